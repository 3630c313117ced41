/** Values beside the cursor. */
import { el } from '../dom';
import { axisTitle, shown } from '../format';
import { swatch } from './legend';
import type { Near } from './nearest';
import type { Mark, Num, Plot } from '../data';

const mostRows = 12;

function abscissa(plot: Plot, x: Num): string {
  return x === null ? '–' : (plot.x.categories[x] ?? shown(x));
}

function row(plot: Plot, { drawn: { series, style }, index }: Near, isNearest: boolean): HTMLTableRowElement {
  const low = series.low[index] ?? null,
    high = series.high[index] ?? null;
  const interval = low === null && high === null ? '' : ` [${shown(low)}, ${shown(high)}]`;
  return el(
    'tr',
    isNearest ? { class: 'nearest' } : {},
    el('th', { scope: 'row' }, swatch(series, style), series.name),
    el('td', {}, abscissa(plot, series.x[index] ?? null)),
    el('td', {}, shown(series.y[index] ?? null) + interval),
  );
}

export function readoutOf(plot: Plot, found: Near[], mark: Mark | undefined): HTMLElement[] {
  const nearest = found.reduce((best, one) => (one.distance < best.distance ? one : best));
  // Of many series those nearest to the cursor, in the order of the legend.
  const rows = [...found].sort((a, b) => a.distance - b.distance).slice(0, mostRows);
  const table = el(
    'table',
    {},
    el(
      'thead',
      {},
      el(
        'tr',
        {},
        el('td'),
        el('th', { scope: 'col' }, axisTitle(plot.x)),
        el('th', { scope: 'col' }, axisTitle(plot.y)),
      ),
    ),
    el(
      'tbody',
      {},
      ...found.filter((one) => rows.includes(one)).map((one) => row(plot, one, one === nearest)),
    ),
  );
  const parts: HTMLElement[] = mark ? [el('p', { class: 'mark' }, mark.label), table] : [table];
  if (found.length > mostRows) parts.push(el('p', {}, `and ${found.length - mostRows} more series`));
  return parts;
}
