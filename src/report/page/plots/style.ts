/**
 * How series are told apart: by the colours of Okabe and Ito ("Color Universal Design", 2008), which
 * colour-blind readers tell apart, and without colour by dash and marker. What is compared with is neutral
 * and dashed.
 */
import { cssValue } from '../dom';
import type { Series } from '../data';

export type Marker = 'circle' | 'square' | 'triangle' | 'diamond' | 'wedge' | 'cross';

export interface Style {
  /** a name of page.css, so that screen, dark screen and paper each have their own */
  colour: string;
  dash: number[];
  marker: Marker;
  /** hollow markers and bars */
  hollow: boolean;
}

const colours = 7;
const dashes = [[], [7, 3], [2, 3], [9, 3, 2, 3]];
const referenceDashes = [
  [6, 4],
  [2, 3],
  [10, 4, 2, 4],
];
const markers: Marker[] = ['circle', 'square', 'triangle', 'diamond', 'wedge', 'cross'];

export function stylesOf(series: Series[]): Style[] {
  let own = 0;
  let references = 0;
  return series.map((one): Style => {
    const i = one.reference ? references++ : (one.place ?? own++);
    const marker = markers[i % markers.length] as Marker;
    if (one.reference)
      return { colour: '--reference', dash: referenceDashes[i % 3] as number[], marker, hollow: true };
    const dash = dashes[Math.floor(i / colours) % dashes.length] as number[];
    return { colour: `--series-${(i % colours) + 1}`, dash, marker, hollow: false };
  });
}

export function colourOf(style: Style): string {
  return cssValue(style.colour);
}

export function hasLine(series: Series): boolean {
  return series.draw === 'line' || series.draw === 'line_and_points' || series.draw === 'steps';
}

export function hasMarkers(series: Series): boolean {
  return series.draw === 'points' || series.draw === 'line_and_points';
}
