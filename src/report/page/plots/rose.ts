/** An orientation rose: petals around a circle, as an SVG of our own. */
import { cssValue, el, svg } from '../dom';
import { axisTitle, shown, sharedExponent, tickTexts } from '../format';
import type { Style } from './style';
import type { Plot, Series } from '../data';

const size = 280,
  centre = size / 2,
  outer = 100;

function at(angle: number, radius: number): [number, number] {
  const radians = (angle * Math.PI) / 180;
  return [centre + radius * Math.cos(radians), centre - radius * Math.sin(radians)];
}

function wedge(from: number, to: number, radius: number): string {
  const [x0, y0] = at(from, radius),
    [x1, y1] = at(to, radius);
  const large = to - from > 180 ? 1 : 0;
  return `M${centre} ${centre}L${x0} ${y0}A${radius} ${radius} 0 ${large} 0 ${x1} ${y1}Z`;
}

/** How far the angles lie apart, degrees. */
function petalWidth(series: Series): number {
  const angles = series.x.filter((x): x is number => x !== null).sort((a, b) => a - b);
  let least = 360;
  for (let i = 1; i < angles.length; ++i) {
    const gap = (angles[i] as number) - (angles[i - 1] as number);
    if (gap > 1e-9) least = Math.min(least, gap);
  }
  return Math.min(least, 359.99);
}

/** Some three circles of round radii. */
function ringsUpTo(largest: number): { step: number; rings: number[] } {
  const rough = largest / 3,
    power = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 2.5, 5, 10].find((digit) => digit * power >= rough * 0.999) ?? 10) * power;
  const rings: number[] = [];
  for (let i = 1; i * step <= largest * 1.0001 || i === 1; ++i) rings.push(i * step);
  return { step, rings };
}

export interface Rose {
  element: HTMLElement;
  /** as a file of its own, its colours resolved */
  picture(): Blob;
  setVisible(index: number, on: boolean): void;
}

interface Petal {
  path: SVGPathElement;
  length: number;
}

function petalsOf(plot: Plot, series: Series, style: Style, scale: number, readout: HTMLElement): Petal[] {
  const width = petalWidth(series),
    colour = `var(${style.colour})`;
  const look: Record<string, string | number> = style.hollow
    ? {
        fill: 'none',
        stroke: colour,
        'stroke-width': 1.5,
        'stroke-dasharray': style.dash.join(' '),
        'pointer-events': 'all',
      }
    : { fill: colour, stroke: 'var(--paper)', 'stroke-width': 0.75 };
  const unit = plot.y.unit === '' ? '' : ` ${plot.y.unit}`;
  const name = series.name === '' ? '' : `${series.name}: `;
  return series.x.flatMap((x, i) => {
    const length = series.y[i] ?? null;
    if (x === null || length === null || length <= 0) return [];
    const path = svg('path', { d: wedge(x - width / 2, x + width / 2, scale * length), ...look });
    path.addEventListener('pointerenter', () => {
      readout.hidden = false;
      readout.textContent = `${name}${shown(length)}${unit} at ${shown(x)}°`;
    });
    path.addEventListener('pointerleave', () => (readout.hidden = true));
    return [{ path, length }];
  });
}

/** Undefined where there is no length to draw. */
export function rosePlot(plot: Plot, styles: Style[]): Rose | undefined {
  const lengths = plot.series.flatMap((series) => series.y).filter((y): y is number => y !== null && y > 0);
  if (lengths.length === 0) return undefined;
  const largest = lengths.reduce((a, b) => Math.max(a, b), 0);
  const { step, rings } = ringsUpTo(largest);
  const full = Math.max(largest, rings.at(-1) as number);
  const exponent = sharedExponent(0, full);
  const drawing = svg('svg', {
    viewBox: `0 0 ${size} ${size + 18}`,
    role: 'img',
    'aria-label': plot.title,
    class: 'rose',
  });
  const readout = el('div', { class: 'readout rose-readout', role: 'status', hidden: '' });

  for (const ring of rings)
    drawing.append(
      svg('circle', {
        cx: centre,
        cy: centre,
        r: (outer * ring) / full,
        fill: 'none',
        stroke: 'var(--grid)',
      }),
    );
  for (let angle = 0; angle < 360; angle += 30) {
    const [x, y] = at(angle, outer),
      [tx, ty] = at(angle, outer + 15);
    drawing.append(
      svg('line', { x1: centre, y1: centre, x2: x, y2: y, stroke: 'var(--grid)' }),
      svg(
        'text',
        { x: tx, y: ty + 4, 'text-anchor': 'middle', 'font-size': 11, fill: 'var(--muted)' },
        `${angle}°`,
      ),
    );
  }
  const petals = plot.series.flatMap((series, index) =>
    petalsOf(plot, series, styles[index] as Style, outer / full, readout).map((petal) => ({
      ...petal,
      index,
    })),
  );
  // Shorter petals lie on longer ones, so that each is seen.
  drawing.append(...petals.sort((a, b) => b.length - a.length).map(({ path }) => path));
  const texts = tickTexts(rings, step, exponent);
  rings.forEach((ring, i) => {
    const [x, y] = at(75, (outer * ring) / full);
    drawing.append(
      svg(
        'text',
        {
          x,
          y: y + 4,
          'text-anchor': 'middle',
          'font-size': 11,
          fill: 'var(--ink)',
          stroke: 'var(--paper)',
          'stroke-width': 3,
          'paint-order': 'stroke',
        },
        texts[i] as string,
      ),
    );
  });
  const centred = { x: centre, 'text-anchor': 'middle', 'font-size': 12 };
  drawing.append(
    svg('text', { ...centred, y: size - 3, fill: 'var(--ink)' }, axisTitle(plot.y, exponent)),
    svg('text', { ...centred, y: size + 13, fill: 'var(--muted)' }, plot.x.label),
  );

  return {
    element: el('div', { class: 'canvas' }, readout, drawing),
    setVisible: (index, on) => {
      for (const petal of petals)
        if (petal.index === index) petal.path.setAttribute('display', on ? 'inline' : 'none');
    },
    picture: () => {
      const copy = drawing.cloneNode(true) as SVGElement;
      copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
      copy.setAttribute('font-family', 'system-ui, sans-serif');
      copy.prepend(
        svg('title', {}, plot.title),
        svg('rect', { width: size, height: size + 18, fill: 'var(--paper)' }),
      );
      const resolved = new XMLSerializer()
        .serializeToString(copy)
        .replace(/="var\((--[a-z0-9-]+)\)"/g, (_, name: string) => `="${cssValue(name)}"`);
      return new Blob([resolved], { type: 'image/svg+xml' });
    },
  };
}
