/** Draws the series of a plot onto the canvas of uPlot, which has drawn axes and grid. */
import uPlot from 'uplot';
import { cssValue } from '../dom';
import { drawBars, drawIntervals } from './bars';
import { xPixel, yPixel } from './screen';
import type { Canvas, Drawn } from './drawn';
import { drawMarks } from './marks';
import { inside, traceLine, traceMarker } from './paths';
import { colourOf, hasLine, hasMarkers } from './style';
import type { Plot } from '../data';

function zeroLines({ u, context, plot, unit, box }: Canvas): void {
  context.strokeStyle = cssValue('--muted');
  context.lineWidth = unit;
  context.setLineDash([]);
  context.beginPath();
  const { x, y } = u.scales;
  if (!plot.y.log && (y?.min ?? 0) <= 0 && (y?.max ?? 0) >= 0) {
    const at = Math.round(yPixel(u, 0)) + 0.5;
    context.moveTo(box.left, at);
    context.lineTo(box.right, at);
  }
  if (!plot.x.log && plot.x.categories.length === 0 && (x?.min ?? 0) <= 0 && (x?.max ?? 0) >= 0) {
    const at = Math.round(xPixel(u, 0)) + 0.5;
    context.moveTo(at, box.top);
    context.lineTo(at, box.bottom);
  }
  context.stroke();
}

function line({ context, unit, box }: Canvas, { series, style, screen }: Drawn): void {
  const room = 20 * unit;
  context.beginPath();
  traceLine(context, screen, series.draw === 'steps', {
    left: box.left - room,
    right: box.right + room,
    top: box.top - room,
    bottom: box.bottom + room,
  });
  context.strokeStyle = colourOf(style);
  context.lineWidth = (series.reference ? 1.5 : 1.75) * unit;
  context.lineJoin = 'round';
  context.setLineDash(style.dash.map((part) => part * unit));
  context.stroke();
}

/** Also shows a value alone between two gaps, through which no line goes. */
function markers({ context, unit, box }: Canvas, { series, style, screen }: Drawn): void {
  const many = screen.x.length > 2000;
  const radius = (many ? 2 : series.draw === 'line_and_points' ? 3 : 3.5) * unit;
  const path = new Path2D();
  const taken = new Set<number>();
  const { x: xs, y: ys } = screen;
  for (let i = 0; i < xs.length; ++i) {
    const x = xs[i] as number,
      y = ys[i] as number;
    if (Number.isNaN(x) || !inside(box, x, y, radius)) continue;
    const alone = Number.isNaN(xs[i - 1] ?? NaN) && Number.isNaN(xs[i + 1] ?? NaN);
    if (!hasMarkers(series) && !alone) continue;
    const place = Math.round(x / unit) * 1e5 + Math.round(y / unit);
    if (taken.has(place)) continue;
    taken.add(place);
    traceMarker(path, style.marker, x, y, radius);
  }
  context.setLineDash([]);
  context.lineWidth = 1.25 * unit;
  context.strokeStyle = colourOf(style);
  context.fillStyle = style.hollow ? cssValue('--paper') : colourOf(style);
  context.fill(path);
  if (style.hollow) context.stroke(path);
}

/** `zoom`: see fontOf(). */
export function drawSeries(u: uPlot, plot: Plot, shown: Drawn[], zoom: number): void {
  const { left, top, width, height } = u.bbox;
  const box = { left, top, right: left + width, bottom: top + height };
  const canvas: Canvas = { u, context: u.ctx, plot, unit: zoom * uPlot.pxRatio, box };
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.rect(left, top, width, height);
  u.ctx.clip();
  zeroLines(canvas);
  const places = drawBars(canvas, shown);
  // What the others are compared with lies beneath them.
  for (const one of [...shown].sort((a, b) => Number(b.series.reference) - Number(a.series.reference))) {
    drawIntervals(canvas, one, places.get(one));
    if (hasLine(one.series)) line(canvas, one);
    if (one.series.draw !== 'bars') markers(canvas, one);
  }
  drawMarks(canvas);
  u.ctx.restore();
}
