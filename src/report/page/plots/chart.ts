/**
 * A plot on a canvas: uPlot gives scales, axes, cursor and zoom; the series are drawn by draw.ts, because
 * uPlot's own paths want x in ascending order, and a load-displacement path may snap back.
 */
import uPlot from 'uplot';
import { cssValue } from '../dom';
import { axisOf } from './axes';
import { drawSeries } from './draw';
import type { Drawn } from './drawn';
import { screenOf } from './screen';
import type { Style } from './style';
import type { View } from './range';
import type { Plot } from '../data';

export interface Asked {
  plot: Plot;
  styles: Style[];
  /** which series are to be seen */
  visible: boolean[];
  view: View;
}

export interface Chart {
  u: uPlot;
  /** series that are seen, where they were drawn last */
  drawn: Drawn[];
}

/** `zoom`: see fontOf(). `more` are options of who reacts to the cursor. `asked` is read at each drawing. */
export function chartOf(
  host: HTMLElement,
  asked: Asked,
  width: number,
  height: number,
  zoom: number,
  more: Pick<uPlot.Options, 'cursor' | 'hooks'>,
): Chart {
  const { plot } = asked;
  const chart: { u?: uPlot; drawn: Drawn[] } = { drawn: [] };
  const draw = (u: uPlot): void => {
    chart.drawn = plot.series
      .map((series, i) => ({ series, style: asked.styles[i] as Style, i }))
      .filter(({ i }) => asked.visible[i])
      .map(({ series, style }) => ({ series, style, screen: screenOf(u, plot, series) }));
    drawSeries(u, plot, chart.drawn, zoom);
  };
  const scale = (axis: 'x' | 'y'): uPlot.Scale => ({
    time: false,
    distr: plot[axis].log ? 3 : 1,
    log: 10,
    range: () => [asked.view[axis].min, asked.view[axis].max],
  });
  chart.u = new uPlot(
    {
      width: width * zoom,
      height: height * zoom,
      legend: { show: false },
      padding: [10 * zoom, 14 * zoom, 0, 0],
      scales: { x: scale('x'), y: scale('y') },
      axes: [axisOf(plot, true, zoom), axisOf(plot, false, zoom)],
      series: [{}, { show: false }],
      cursor: more.cursor ?? { show: false },
      hooks: { ...more.hooks, drawClear: [paper], draw: [draw] },
      // uPlot asks for a row of x; the two are never drawn.
    },
    [
      [1, 2],
      [null, null],
    ],
    host,
  );
  return chart as Chart;
}

/** A picture that is opened elsewhere has no page beneath it. */
function paper(u: uPlot): void {
  u.ctx.save();
  u.ctx.fillStyle = cssValue('--paper');
  u.ctx.fillRect(0, 0, u.ctx.canvas.width, u.ctx.canvas.height);
  u.ctx.restore();
}

/** Draws at once what `asked` has become; by itself uPlot waits for the end of the turn. */
export function redraw({ u }: Chart, { view }: Asked): void {
  u.batch(() => {
    u.setScale('x', view.x);
    u.setScale('y', view.y);
    u.redraw(true, true);
  });
}

/** The plot on a canvas of its own, `zoom` times finer than a page. */
export function pictureOf(asked: Asked, width: number, height: number, zoom: number): HTMLCanvasElement {
  const chart = chartOf(document.createElement('div'), asked, width, height, zoom / uPlot.pxRatio, {});
  redraw(chart, asked);
  const canvas = chart.u.ctx.canvas;
  chart.u.destroy();
  return canvas;
}
