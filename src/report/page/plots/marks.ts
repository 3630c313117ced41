/** Points that have a name of their own: first break, peak. */
import { cssValue } from '../dom';
import { cutTo, fontOf } from './axes';
import { drawable } from './range';
import { xPixel, yPixel } from './screen';
import { inside, traceMarker, type Box } from './paths';
import type { Canvas } from './drawn';

function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

function around(x: number, y: number, halfWidth: number, halfHeight: number): Box {
  return { left: x - halfWidth, right: x + halfWidth, top: y - halfHeight, bottom: y + halfHeight };
}

/** Where a label may stand about its point, in the order in which places are tried. */
const places: [number, number][] = [
  [1, -1],
  [1, 0],
  [1, 1],
  [-1, -1],
  [-1, 0],
  [-1, 1],
  [0, -2],
  [0, 2],
];

/**
 * A label goes where it covers nothing else that is marked, and is left to the readout where there is no
 * place.
 */
export function drawMarks({ u, context, plot, unit, box }: Canvas): void {
  const points = plot.marks
    .flatMap(({ x, y, label }) =>
      drawable(x, plot.x.log) && drawable(y, plot.y.log) ? [{ x: xPixel(u, x), y: yPixel(u, y), label }] : [],
    )
    .filter(({ x, y }) => inside(box, x, y));
  const taken = points.map(({ x, y }) => around(x, y, 5 * unit, 5 * unit));
  context.font = fontOf(unit, 11.5);
  context.textBaseline = 'middle';
  context.textAlign = 'center';
  context.lineJoin = 'round';
  context.setLineDash([]);
  const ink = cssValue('--ink'),
    paper = cssValue('--paper');
  for (const { x, y, label } of points) {
    context.beginPath();
    traceMarker(context, 'diamond', x, y, 4.5 * unit);
    context.fillStyle = paper;
    context.strokeStyle = ink;
    context.lineWidth = 1.5 * unit;
    context.fill();
    context.stroke();
    const text = cutTo(context, label, (box.right - box.left) * 0.6);
    const half = context.measureText(text).width / 2;
    const free = places
      .map(([dx, dy]) => around(x + dx * (half + 8 * unit), y + dy * 8 * unit, half, 7 * unit))
      .find(
        (place) =>
          inside(box, place.left, place.top) &&
          inside(box, place.right, place.bottom) &&
          !taken.some((other) => overlap(place, other)),
      );
    if (!free) continue;
    taken.push(free);
    const middle = (free.left + free.right) / 2,
      height = (free.top + free.bottom) / 2;
    context.lineWidth = 3 * unit;
    context.strokeStyle = paper;
    context.strokeText(text, middle, height);
    context.fillStyle = ink;
    context.fillText(text, middle, height);
  }
}
