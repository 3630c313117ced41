/** The numbers of a plot, all digits. */
import { csv } from '../csv';
import { axisTitle } from '../format';
import type { Num, Plot, Series } from '../data';

type Cell = string | Num;

function abscissa(plot: Plot, x: Num): Cell {
  return x === null ? null : (plot.x.categories[x] ?? x);
}

function hasInterval(series: Series): boolean {
  return series.low.length > 0 || series.high.length > 0;
}

function shareX(series: Series[]): boolean {
  const first = series[0]?.x ?? [];
  return series.every(({ x }) => x.length === first.length && x.every((value, i) => value === first[i]));
}

/** A column each series where all have the same x. */
function wide(plot: Plot): Cell[][] {
  const unit = plot.y.unit === '' ? '' : ` (${plot.y.unit})`;
  const header = [axisTitle(plot.x)];
  for (const series of plot.series) {
    header.push((series.name || plot.y.label) + unit);
    if (hasInterval(series)) header.push(`${series.name} low${unit}`, `${series.name} high${unit}`);
  }
  const rows = (plot.series[0]?.x ?? []).map((x, i) => [
    abscissa(plot, x),
    ...plot.series.flatMap((series) => {
      const y = series.y[i] ?? null;
      return hasInterval(series) ? [y, series.low[i] ?? null, series.high[i] ?? null] : [y];
    }),
  ]);
  return [header, ...rows];
}

/** A row each point, with the name of its series; marks are points under their label. */
function long(plot: Plot): Cell[][] {
  const intervals = plot.series.some(hasInterval);
  const header = ['series', axisTitle(plot.x), axisTitle(plot.y), ...(intervals ? ['low', 'high'] : [])];
  const rows: Cell[][] = plot.series.flatMap((series) =>
    series.x.map((x, i) => [
      series.name,
      abscissa(plot, x),
      series.y[i] ?? null,
      ...(intervals ? [series.low[i] ?? null, series.high[i] ?? null] : []),
    ]),
  );
  for (const mark of plot.marks)
    rows.push([mark.label, abscissa(plot, mark.x), mark.y, ...(intervals ? [null, null] : [])]);
  return [header, ...rows];
}

export function plotCsv(plot: Plot): string {
  return csv(plot.marks.length === 0 && shareX(plot.series) ? wide(plot) : long(plot));
}
