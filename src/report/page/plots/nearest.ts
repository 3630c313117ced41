/** What lies nearest to the cursor. */
import type { Drawn } from './drawn';
import type { Box } from './paths';

export interface Near {
  drawn: Drawn;
  index: number;
  /** canvas pixels from the cursor */
  distance: number;
}

/**
 * Of each series the point in sight that is nearest to (x, y), in canvas pixels: in x where the series is a
 * function of x, as the eye reads it, and in the plane where it goes back and forth.
 */
export function nearestOf(all: Drawn[], x: number, y: number, box: Box): Near[] {
  const found: Near[] = [];
  for (const drawn of all) {
    const { x: xs, y: ys, ascending } = drawn.screen;
    const plane = !ascending || drawn.series.draw === 'points';
    let best = -1,
      least = Infinity,
      leastY = Infinity;
    for (let i = 0; i < xs.length; ++i) {
      const px = xs[i] as number,
        py = ys[i] as number;
      if (!(px >= box.left - 1 && px <= box.right + 1 && py >= box.top - 1 && py <= box.bottom + 1)) continue;
      const away = plane ? (px - x) ** 2 + (py - y) ** 2 : Math.abs(px - x),
        awayY = Math.abs(py - y);
      if (away < least || (away === least && awayY < leastY)) {
        best = i;
        least = away;
        leastY = awayY;
      }
    }
    if (best >= 0)
      found.push({
        drawn,
        index: best,
        distance: Math.hypot((xs[best] as number) - x, (ys[best] as number) - y),
      });
  }
  return found;
}
