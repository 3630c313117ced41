/** What a plot shows before anybody zooms. */
import type { Num, Plot, Series } from '../data';

export interface Range {
  min: number;
  max: number;
}

export interface View {
  x: Range;
  y: Range;
}

export function drawable(value: Num | undefined, log: boolean): value is number {
  return typeof value === 'number' && Number.isFinite(value) && (!log || value > 0);
}

/** Values of an axis that a logarithm cannot show. */
export function countWithoutLogarithm(plot: Plot): number {
  let found = 0;
  for (const series of plot.series)
    for (let i = 0; i < series.x.length; ++i) {
      const x = series.x[i] ?? null,
        y = series.y[i] ?? null;
      if (x === null || y === null) continue;
      if ((plot.x.log && x <= 0) || (plot.y.log && y <= 0)) ++found;
    }
  return found;
}

/**
 * Least distance of the bars of a plot, in its units or, on a logarithmic axis, decades; NaN without bars.
 */
export function barSpacing(plot: Plot, series: Series[]): number {
  const at = new Set<number>();
  for (const one of series)
    if (one.draw === 'bars')
      for (const x of one.x) if (drawable(x, plot.x.log)) at.add(plot.x.log ? Math.log10(x) : x);
  if (at.size === 0) return NaN;
  const sorted = [...at].sort((a, b) => a - b);
  let least = Infinity;
  // What differs by rounding is the same place.
  const rounding = 1e-9 * ((sorted.at(-1) as number) - (sorted[0] as number));
  for (let i = 1; i < sorted.length; ++i) {
    const apart = (sorted[i] as number) - (sorted[i - 1] as number);
    if (apart > rounding) least = Math.min(least, apart);
  }
  return Number.isFinite(least) ? least : 1;
}

class Extent {
  min = Infinity;
  max = -Infinity;
  constructor(private readonly log: boolean) {}

  add(value: Num | undefined): void {
    if (!drawable(value, this.log)) return;
    this.min = Math.min(this.min, value);
    this.max = Math.max(this.max, value);
  }

  /** With room around, and with zero where it is near enough to be worth its place. */
  padded(zero: boolean): Range {
    let { min, max } = this;
    if (min > max) return this.log ? { min: 0.1, max: 1 } : { min: 0, max: 1 };
    if (this.log) {
      const room = min === max ? Math.log10(2) : 0.04 * Math.log10(max / min);
      return { min: min / 10 ** room, max: max * 10 ** room };
    }
    if (zero || (min > 0 && min < 0.3 * (max - min))) min = Math.min(min, 0);
    if (zero || (max < 0 && -max < 0.3 * (max - min))) max = Math.max(max, 0);
    // A constant differs from itself by rounding only; that must not look like a signal.
    const least = 1e-12 * Math.max(Math.abs(min), Math.abs(max));
    const room = max - min > least ? 0.05 * (max - min) : 0.1 * Math.max(Math.abs(min), Math.abs(max)) || 1;
    return { min: min === 0 && zero ? 0 : min - room, max: max === 0 && zero ? 0 : max + room };
  }
}

/** Undefined where there is nothing to be drawn. */
export function fullView(plot: Plot, series: Series[]): View | undefined {
  const x = new Extent(plot.x.log),
    y = new Extent(plot.y.log);
  for (const one of series)
    for (let i = 0; i < one.x.length; ++i) {
      if (!drawable(one.x[i], plot.x.log) || !drawable(one.y[i], plot.y.log)) continue;
      x.add(one.x[i]);
      for (const value of [one.y[i], one.low[i], one.high[i]]) y.add(value);
    }
  if (x.min > x.max) return undefined;
  for (const mark of plot.marks)
    if (drawable(mark.x, plot.x.log) && drawable(mark.y, plot.y.log)) {
      x.add(mark.x);
      y.add(mark.y);
    }
  const view = { x: x.padded(false), y: y.padded(series.some((one) => one.draw === 'bars')) };
  const half = barSpacing(plot, series) / 2;
  if (plot.x.categories.length > 0) {
    view.x = { min: -0.6, max: plot.x.categories.length - 0.4 };
  } else if (!Number.isNaN(half)) {
    view.x = plot.x.log
      ? { min: Math.min(view.x.min, x.min / 10 ** half), max: Math.max(view.x.max, x.max * 10 ** half) }
      : { min: x.min - 1.2 * half, max: x.max + 1.2 * half };
  }
  return view;
}
