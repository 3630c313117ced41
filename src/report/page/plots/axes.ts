/**
 * Axes of uPlot with ticks that engineers read: a shared power of ten in the title, decades on a
 * logarithmic one.
 */
import uPlot from 'uplot';
import { axisTitle, powerOfTen, sharedExponent, tickTexts } from '../format';
import { cssValue } from '../dom';
import type { Plot } from '../data';

const family = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

/**
 * `zoom`: canvas pixels are that many times those of the page; pictures and paper are drawn finer than
 * screens.
 */
export function fontOf(zoom: number, size = 12): string {
  // uPlot scales fonts of whole pixels only.
  return `${Math.round(size * zoom)}px ${family}`;
}

/** uPlot caches the state of its context, so it must be found again as it was. */
function withFont<T>(u: uPlot, zoom: number, measure: (context: CanvasRenderingContext2D) => T): T {
  u.ctx.save();
  u.ctx.font = fontOf(zoom);
  const result = measure(u.ctx);
  u.ctx.restore();
  return result;
}

function widest(u: uPlot, texts: (string | number | null)[], zoom: number): number {
  return withFont(u, zoom, (context) =>
    Math.max(0, ...texts.map((text) => context.measureText(String(text ?? '')).width)),
  );
}

/** Of the plotting area, in the pixels that fonts are measured in: uPlot's box is in those of the canvas. */
function lengthOf(u: uPlot, isX: boolean): number {
  return (isX ? u.bbox.width : u.bbox.height) / uPlot.pxRatio;
}

/** Cut so that it is at most `width` long in the context's font. */
export function cutTo(context: CanvasRenderingContext2D, text: string, width: number): string {
  if (context.measureText(text).width <= width) return text;
  let end = text.length;
  while (end > 1 && context.measureText(text.slice(0, end) + '…').width > width) --end;
  return text.slice(0, end).trimEnd() + '…';
}

/** Decades, and between them more digits where few decades are in sight. */
function logTicks(min: number, max: number, most: number): number[] {
  const first = Math.floor(Math.log10(min));
  const last = Math.ceil(Math.log10(max));
  const every = Math.max(1, Math.ceil((last - first) / Math.max(1, most)));
  const decades = Math.log10(max / min);
  const within = [
    [1, 2, 3, 4, 5, 6, 7, 8, 9],
    [1, 2, 5],
    [1, 3],
  ].find((digits) => digits.length * decades <= most);
  const ticks: number[] = [];
  for (let e = every * Math.floor(first / every); e <= last; e += every)
    for (const digit of every === 1 && within ? within : [1]) {
      const tick = Number(`${digit}e${e}`);
      if (tick >= min && tick <= max) ticks.push(tick);
    }
  return ticks;
}

function logTexts(ticks: number[]): string[] {
  const plain = ticks.every((tick) => tick >= 0.99e-3 && tick < 1e5);
  return ticks.map((tick) => {
    const exponent = Math.floor(Math.log10(tick) + 1e-9);
    const digit = Math.round(tick / 10 ** exponent);
    if (plain || Math.abs(exponent) < 2) return String(tick);
    return digit === 1 ? powerOfTen(exponent) : `${digit}·${powerOfTen(exponent)}`;
  });
}

/** Digits that a label needs grow with how deep one has zoomed in. */
function labelLength(min: number, max: number): number {
  const size = Math.max(Math.abs(min), Math.abs(max));
  return 4 + Math.max(0, Math.ceil(Math.log10(size / (max - min) || 1)));
}

/** Whole numbers are counted in whole steps. */
const wholeSteps = Array.from({ length: 15 }, (_, e) => [1, 2, 5].map((digit) => digit * 10 ** e)).flat();

export function axisOf(plot: Plot, isX: boolean, zoom: number): uPlot.Axis {
  const axis = isX ? plot.x : plot.y;
  const names = axis.categories;
  const ink = (): string => cssValue('--ink');
  const line = { stroke: () => cssValue('--grid'), width: 1 * zoom };
  const limits = (u: uPlot): [number, number] => {
    const scale = u.scales[isX ? 'x' : 'y'];
    return [scale?.min ?? 0, scale?.max ?? 1];
  };
  const made: uPlot.Axis = {
    scale: isX ? 'x' : 'y',
    stroke: ink,
    font: fontOf(zoom),
    labelFont: fontOf(zoom),
    labelGap: 3 * zoom,
    labelSize: 22 * zoom,
    gap: 4 * zoom,
    grid: line,
    ticks: { ...line, size: 5 * zoom },
    filter: (_, splits) => splits,
    label: (u) => {
      const title = axisTitle(axis, axis.log || names.length > 0 ? 0 : sharedExponent(...limits(u)));
      return withFont(u, zoom, (context) => cutTo(context, title, lengthOf(u, isX)));
    },
    values: (u, ticks, _axis, _space, increment) => {
      if (names.length > 0) return ticks.map((tick) => names[tick] ?? '');
      return axis.log ? logTexts(ticks) : tickTexts(ticks, increment, sharedExponent(...limits(u)));
    },
    space: (_u, _axis, min, max) => (isX ? 20 + 7 * labelLength(min, max) : 32) * zoom,
    size: (u, values) => {
      if (!isX) return widest(u, values ?? [], zoom) + 11 * zoom;
      // 0.64: the sine of the angle by which names are turned
      return slanted(u, names, zoom)
        ? 0.64 * Math.min(110 * zoom, widest(u, names, zoom)) + 20 * zoom
        : 26 * zoom;
    },
  };
  if (names.length > 0) {
    made.splits = (u, _axis, min, max) => {
      const all = names.map((_, i) => i).filter((i) => i >= min && i <= max);
      const every = Math.ceil((all.length * 16 * zoom) / Math.max(1, lengthOf(u, true)));
      return all.filter((_, i) => i % every === 0);
    };
    made.rotate = (u) => (slanted(u, names, zoom) ? -40 : 0);
    made.values = (u, ticks) => {
      return withFont(u, zoom, (context) =>
        ticks.map((tick) => cutTo(context, names[tick] ?? '', 110 * zoom)),
      );
    };
  } else if (axis.log) {
    made.splits = (u, _axis, min, max) => {
      const length = lengthOf(u, isX) / zoom;
      return logTicks(min, max, Math.max(2, Math.floor(length / (isX ? 50 : 28))));
    };
  }
  const values = plot.series
    .flatMap((series) => (isX ? series.x : series.y))
    .filter((value) => value !== null);
  const isCount = values.every((value) => Number.isInteger(value) && Math.abs(value) < 1e9);
  if (isCount && values.some((value) => Math.abs(value - (values[0] ?? 0)) > 1)) made.incrs = wholeSteps;
  return made;
}

/** Names that do not fit beside each other are turned. */
function slanted(u: uPlot, names: string[], zoom: number): boolean {
  const { min, max } = u.scales['x'] ?? {};
  const inSight = Math.max(1, Math.min(names.length, (max ?? names.length) - (min ?? 0)));
  return names.length > 0 && widest(u, names, zoom) + 10 * zoom > lengthOf(u, true) / inSight;
}
