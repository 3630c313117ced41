/** A plot that answers: the cursor reads values, dragging zooms, a double click shows all again. */
import uPlot from 'uplot';
import { el } from '../dom';
import { whenPrinted } from '../print';
import { chartOf, pictureOf, redraw, type Asked, type Chart } from './chart';
import { walkByKeys } from './keys';
import { nearestOf, type Near } from './nearest';
import { fullView } from './range';
import { readoutOf } from './readout';
import type { Style } from './style';
import type { Mark, Plot } from '../data';

/** Of plots on paper, in pixels of the page; two of them fit beside each other on A4. */
const paper = { width: 330, height: 230 };

export interface Interactive {
  element: HTMLElement;
  asked: Asked;
  setVisible(index: number, on: boolean): void;
}

function markNear({ u }: Chart, plot: Plot, x: number, y: number): Mark | undefined {
  const reach = 14 * uPlot.pxRatio;
  return plot.marks.find(
    (mark) =>
      mark.x !== null &&
      mark.y !== null &&
      Math.hypot(u.valToPos(mark.x, 'x', true) - x, u.valToPos(mark.y, 'y', true) - y) < reach,
  );
}

/** Rings around the points that the readout tells of. */
function ringsOf(found: Near[], { left, top }: uPlot.BBox): HTMLElement[] {
  return found.map(({ drawn, index }) => {
    const x = ((drawn.screen.x[index] as number) - left) / uPlot.pxRatio;
    const y = ((drawn.screen.y[index] as number) - top) / uPlot.pxRatio;
    return el('div', {
      class: 'ring',
      style: `left:${x}px;top:${y}px;border-color:var(${drawn.style.colour})`,
    });
  });
}

/** Tells what is near (left, top), pixels of the page from the corner of the plotting area. */
function showReadout(
  chart: Chart,
  plot: Plot,
  readout: HTMLElement,
  rings: HTMLElement,
  left: number,
  top: number,
): void {
  const { bbox } = chart.u;
  const x = bbox.left + left * uPlot.pxRatio,
    y = bbox.top + top * uPlot.pxRatio;
  const box = {
    left: bbox.left,
    top: bbox.top,
    right: bbox.left + bbox.width,
    bottom: bbox.top + bbox.height,
  };
  const found = left < 0 ? [] : nearestOf(chart.drawn, x, y, box);
  readout.hidden = found.length === 0;
  rings.replaceChildren(...ringsOf(found, bbox));
  if (found.length === 0) return;
  readout.replaceChildren(...readoutOf(plot, found, markNear(chart, plot, x, y)));
  place(readout, chart.u, left);
}

/**
 * Beneath the plotting area, over axis and legend, so that no value is covered; above it where the window
 * ends.
 */
function place(readout: HTMLElement, u: uPlot, left: number): void {
  const area = u.over.getBoundingClientRect(),
    frame = u.root.getBoundingClientRect();
  // Its width must not depend on where it was.
  readout.style.left = '0';
  const { offsetWidth: width, offsetHeight: height } = readout;
  const above = area.bottom + height + 8 > innerHeight && area.top - height > 0;
  const centred = area.left - frame.left + left - width / 2;
  readout.style.left = `${Math.max(0, Math.min(frame.width - width, centred))}px`;
  readout.style.top = `${(above ? area.top - height - 4 : area.bottom + 4) - frame.top}px`;
}

/** Dragging zooms to what was dragged over; by itself uPlot would zoom in its own unused row of x. */
function zoomTo(u: uPlot, asked: Asked): void {
  const { left, top, width, height } = u.select;
  const range = (axis: 'x' | 'y', a: number, b: number): { min: number; max: number } => {
    const ends = [u.posToVal(a, axis), u.posToVal(b, axis)];
    return { min: Math.min(...ends), max: Math.max(...ends) };
  };
  const view = { x: range('x', left, left + width), y: range('y', top, top + height) };
  const resolved = ({ min, max }: { min: number; max: number }): boolean =>
    max - min > 1e-13 * Math.max(Math.abs(min), Math.abs(max));
  if (resolved(view.x) && resolved(view.y)) asked.view = view;
  u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
}

/** Undefined where there is nothing to be drawn. `gone`: when nobody needs it any more. */
export function xyPlot(plot: Plot, styles: Style[], gone?: AbortSignal): Interactive | undefined {
  const visible = plot.series.map(() => true);
  const seen = (): Plot['series'] => plot.series.filter((_, i) => visible[i]);
  const view = fullView(plot, seen());
  if (!view) return undefined;
  const asked: Asked = { plot, styles, visible, view };
  const readout = el('div', { class: 'readout', role: 'status', hidden: '' });
  const rings = el('div', { class: 'rings' });
  const element = el(
    'div',
    { class: 'canvas', role: 'group', 'aria-label': `${plot.title}; arrow keys read values` },
    readout,
  );
  let chart: Chart | undefined;

  const showAll = (): void => {
    asked.view = fullView(plot, seen()) ?? asked.view;
    if (chart) redraw(chart, asked);
  };
  const cursor: uPlot.Cursor = {
    points: { show: false },
    drag: { x: true, y: true, uni: 24, dist: 4, setScale: false },
    bind: {
      dblclick: () => () => {
        showAll();
        return null;
      },
    },
  };
  const hooks: uPlot.Hooks.Arrays = {
    setCursor: [
      ({ cursor: { left, top } }) => chart && showReadout(chart, plot, readout, rings, left ?? -1, top ?? -1),
    ],
    setSelect: [
      (u) => {
        zoomTo(u, asked);
        if (chart) redraw(chart, asked);
      },
    ],
  };
  const forNames = plot.x.categories.some((name) => name.length > 10) ? 70 : 0;
  const fit = (): void => {
    const width = Math.floor(element.clientWidth);
    if (width < 50) return;
    const height = Math.round(Math.min(320, Math.max(240, 0.56 * width))) + forNames;
    if (!chart) {
      chart = chartOf(element, asked, width, height, 1, { cursor, hooks });
      chart.u.over.append(rings);
    } else if (chart.u.width !== width || chart.u.height !== height) {
      chart.u.setSize({ width, height });
    }
  };
  new ResizeObserver(fit).observe(element);
  walkByKeys(element, () => chart);
  const dark = matchMedia('(prefers-color-scheme: dark)');
  dark.addEventListener('change', () => chart && redraw(chart, asked), { signal: gone });

  let printed: HTMLCanvasElement | undefined;
  const paperPicture = {
    start: () => {
      if (element.clientWidth === 0) return;
      printed = pictureOf(asked, paper.width, paper.height + forNames, 3);
      printed.className = 'printed';
      element.append(printed);
    },
    end: () => {
      printed?.remove();
      printed = undefined;
    },
  };
  whenPrinted(paperPicture, gone);
  return {
    element,
    asked,
    setVisible: (index, on) => {
      visible[index] = on;
      showAll();
    },
  };
}
