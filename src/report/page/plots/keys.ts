/** Reads a plot without a mouse: arrow keys walk along the first series that is seen. */
import uPlot from 'uplot';
import type { Chart } from './chart';

export function walkByKeys(element: HTMLElement, chartNow: () => Chart | undefined): void {
  let at = -1;
  element.tabIndex = 0;
  element.addEventListener('keydown', (event) => {
    const chart = chartNow(),
      screen = chart?.drawn[0]?.screen;
    const step = { ArrowLeft: -1, ArrowRight: 1, Escape: 0 }[event.key];
    if (!chart || !screen || step === undefined) return;
    event.preventDefault();
    if (step === 0) {
      chart.u.setCursor({ left: -10, top: -10 }, true);
      return;
    }
    const count = screen.x.length,
      { left, top } = chart.u.bbox;
    let next = at + step;
    while (next >= 0 && next < count && Number.isNaN(screen.x[next])) next += step;
    if (next < 0 || next >= count) return;
    at = next;
    chart.u.setCursor(
      {
        left: ((screen.x[at] as number) - left) / uPlot.pxRatio,
        top: ((screen.y[at] as number) - top) / uPlot.pxRatio,
      },
      true,
    );
  });
}
