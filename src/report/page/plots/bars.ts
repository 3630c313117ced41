/** Bars, and intervals of bars and points. */
import { cssValue } from '../dom';
import { barSpacing, drawable } from './range';
import { xPixel, yPixel } from './screen';
import { colourOf } from './style';
import type { Canvas, Drawn } from './drawn';

/** Left edge and width of each bar of a series, canvas pixels. */
export interface BarPlaces {
  left: Float64Array;
  width: Float64Array;
}

/**
 * Bars of one name stand beside each other. Where x counts no names, bars at the same x share its place,
 * and those that are alone there (a histogram's) have all of it.
 */
function placesOf({ u, plot, unit, box }: Canvas, groups: Drawn[]): Map<Drawn, BarPlaces> {
  const spacing = barSpacing(
    plot,
    groups.map(({ series }) => series),
  );
  const from = u.scales['x']?.min ?? 1;
  const per = Math.max(unit, xPixel(u, plot.x.log ? from * 10 ** spacing : from + spacing) - box.left);
  const at = new Map<number, Drawn[]>();
  const place = (x: number): number => Math.round((4 * x) / per);
  for (const one of groups)
    for (const x of one.screen.x) if (!Number.isNaN(x)) at.set(place(x), [...(at.get(place(x)) ?? []), one]);
  const alone = plot.x.categories.length === 0 && [...at.values()].every((sharing) => sharing.length === 1);
  const whole = per * (alone ? 1 : 0.75);
  return new Map(
    groups.map((one) => {
      const { x } = one.screen;
      const left = new Float64Array(x.length),
        width = new Float64Array(x.length);
      x.forEach((centre, i) => {
        const sharing = plot.x.categories.length > 0 ? groups : (at.get(place(centre)) ?? [one]);
        width[i] = whole / sharing.length;
        left[i] = centre - whole / 2 + sharing.indexOf(one) * (width[i] as number);
      });
      return [one, { left, width }];
    }),
  );
}

export function drawBars(canvas: Canvas, shown: Drawn[]): Map<Drawn, BarPlaces> {
  const groups = shown.filter(({ series }) => series.draw === 'bars');
  const places = placesOf(canvas, groups);
  const { u, context, plot, unit, box } = canvas;
  const base = plot.y.log ? box.bottom : yPixel(u, 0);
  for (const [{ style, screen }, { left, width }] of places) {
    const path = new Path2D();
    screen.y.forEach((y, i) => {
      const from = left[i] as number,
        wide = width[i] as number,
        gap = wide > 4 * unit ? unit : 0;
      if (!Number.isNaN(y) && from + wide >= box.left && from <= box.right)
        path.rect(from + gap / 2, Math.min(y, base), wide - gap, Math.abs(base - y));
    });
    context.strokeStyle = context.fillStyle = colourOf(style);
    context.lineWidth = 1.5 * unit;
    context.setLineDash(style.hollow ? style.dash.map((part) => part * unit) : []);
    context.globalAlpha = style.hollow ? 1 : 0.85;
    if (style.hollow) context.stroke(path);
    else context.fill(path);
    context.globalAlpha = 1;
  }
  return places;
}

export function drawIntervals(
  canvas: Canvas,
  { series, style, screen }: Drawn,
  bars: BarPlaces | undefined,
): void {
  if (series.low.length === 0 && series.high.length === 0) return;
  const { u, context, plot, unit, box } = canvas;
  const path = new Path2D(),
    cap = 4 * unit;
  screen.x.forEach((centre, i) => {
    const low = series.low[i] ?? series.y[i],
      high = series.high[i] ?? series.y[i];
    if (Number.isNaN(centre) || low === high || !drawable(high, plot.y.log)) return;
    const x = bars ? (bars.left[i] as number) + (bars.width[i] as number) / 2 : centre;
    const top = yPixel(u, high),
      bottom = drawable(low, plot.y.log) ? yPixel(u, low) : box.bottom + cap;
    path.moveTo(x, top);
    path.lineTo(x, bottom);
    for (const end of [top, bottom]) {
      path.moveTo(x - cap, end);
      path.lineTo(x + cap, end);
    }
  });
  // Over its own bars an interval would not be seen in their colour.
  context.strokeStyle = bars ? cssValue('--ink') : colourOf(style);
  context.lineWidth = 1.25 * unit;
  context.setLineDash([]);
  context.stroke(path);
}
