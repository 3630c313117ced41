/** Where the values of a series lie on the canvas. */
import type uPlot from 'uplot';
import { drawable } from './range';
import type { Plot, Series } from '../data';

/** In canvas pixels; NaN where there is nothing to draw. */
export interface Screen {
  x: Float64Array;
  y: Float64Array;
  /** x never falls, so that "nearest" can mean nearest in x */
  ascending: boolean;
}

export function xPixel(u: uPlot, value: number): number {
  return u.valToPos(value, 'x', true);
}

export function yPixel(u: uPlot, value: number): number {
  return u.valToPos(value, 'y', true);
}

export function screenOf(u: uPlot, plot: Plot, series: Series): Screen {
  const count = Math.min(series.x.length, series.y.length);
  const screen = { x: new Float64Array(count), y: new Float64Array(count), ascending: true };
  let last = -Infinity;
  for (let i = 0; i < count; ++i) {
    const x = series.x[i] ?? null,
      y = series.y[i] ?? null;
    const there = drawable(x, plot.x.log) && drawable(y, plot.y.log);
    screen.x[i] = there ? xPixel(u, x) : NaN;
    screen.y[i] = there ? yPixel(u, y) : NaN;
    if (!there) continue;
    screen.ascending &&= x >= last;
    last = x;
  }
  return screen;
}
