/** Paths through points in any order, x going back and forth included. */
import type { Marker } from './style';
import type { Screen } from './screen';

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export function inside({ left, right, top, bottom }: Box, x: number, y: number, room = 0): boolean {
  return x >= left - room && x <= right + room && y >= top - room && y <= bottom + room;
}

type Pen = Pick<CanvasPath, 'moveTo' | 'lineTo'>;
export type MarkerPen = Pick<CanvasPath, 'moveTo' | 'lineTo' | 'closePath' | 'rect' | 'arc'>;

/**
 * The part of a segment inside the box, by Liang and Barsky. Dashes along a segment that a deep zoom has made
 * millions of pixels long would stop the browser.
 */
function clipped(
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  box: Box,
): [number, number, number, number] | null {
  let from = 0,
    to = 1;
  const dx = x1 - x0,
    dy = y1 - y0;
  for (const [p, q] of [
    [-dx, x0 - box.left],
    [dx, box.right - x0],
    [-dy, y0 - box.top],
    [dy, box.bottom - y0],
  ] as [number, number][]) {
    if (p === 0) {
      if (q < 0) return null;
    } else if (p < 0) {
      from = Math.max(from, q / p);
    } else {
      to = Math.min(to, q / p);
    }
  }
  return from > to ? null : [x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy];
}

/** Draws to its points and leaves out what lies outside of the box. */
class ClippingPen {
  private x = NaN;
  private y = NaN;
  private connected = false;
  constructor(
    private readonly pen: Pen,
    private readonly box: Box,
  ) {}

  lift(): void {
    this.x = NaN;
  }

  to(x: number, y: number): void {
    const part = Number.isNaN(this.x) ? null : clipped(this.x, this.y, x, y, this.box);
    if (part) {
      if (!this.connected || part[0] !== this.x || part[1] !== this.y) this.pen.moveTo(part[0], part[1]);
      this.pen.lineTo(part[2], part[3]);
    }
    this.connected = part !== null && part[2] === x && part[3] === y;
    this.x = x;
    this.y = y;
  }
}

/**
 * A line through the points. Of points that follow each other within one column of pixels only the first,
 * lowest, highest and last are visited: the picture is the same, and 100,000 points cost as much as the
 * plot is wide.
 */
export function traceLine(pen: Pen, { x, y }: Screen, steps: boolean, box: Box): void {
  const line = new ClippingPen(pen, box);
  let before = NaN;
  const to = (i: number): void => {
    if (steps && !Number.isNaN(before)) line.to(x[i] as number, before);
    line.to(x[i] as number, y[i] as number);
    before = y[i] as number;
  };
  for (let i = 0; i < x.length;) {
    if (Number.isNaN(x[i])) {
      line.lift();
      before = NaN;
      ++i;
      continue;
    }
    const column = Math.floor(x[i] as number);
    let low = i,
      high = i,
      end = i + 1;
    for (; end < x.length && Math.floor(x[end] as number) === column; ++end) {
      if ((y[end] as number) < (y[low] as number)) low = end;
      if ((y[end] as number) > (y[high] as number)) high = end;
    }
    for (const j of [...new Set([i, low, high, end - 1])].sort((a, b) => a - b)) to(j);
    i = end;
  }
}

export function traceMarker(path: MarkerPen, marker: Marker, x: number, y: number, r: number): void {
  const corners = (...at: [number, number][]): void => {
    at.forEach(([dx, dy], i) =>
      i === 0 ? path.moveTo(x + dx * r, y + dy * r) : path.lineTo(x + dx * r, y + dy * r),
    );
    path.closePath();
  };
  if (marker === 'circle') {
    path.moveTo(x + r, y);
    path.arc(x, y, r, 0, 2 * Math.PI);
  } else if (marker === 'square') {
    path.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
  } else if (marker === 'triangle') {
    corners([0, -1.2], [1.1, 0.8], [-1.1, 0.8]);
  } else if (marker === 'diamond') {
    corners([0, -1.3], [1.1, 0], [0, 1.3], [-1.1, 0]);
  } else if (marker === 'wedge') {
    corners([0, 1.2], [1.1, -0.8], [-1.1, -0.8]);
  } else {
    const t = 0.35;
    corners(
      [-t, -1],
      [t, -1],
      [t, -t],
      [1, -t],
      [1, t],
      [t, t],
      [t, 1],
      [-t, 1],
      [-t, t],
      [-1, t],
      [-1, -t],
      [-t, -t],
    );
  }
}
