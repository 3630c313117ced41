/** An ordinate of a sweep over an abscissa, as a plot like any other. */
import type { Abscissa, Ordinate, Plot, Series, Sweep, SweepColumn } from '../data';

export interface Over {
  abscissa: Abscissa;
  log: boolean;
  /** as coarseness is drawn, or the inverse of a slenderness */
  inverse: boolean;
}

export function columnOf(sweep: Sweep, { column }: Abscissa | Ordinate): SweepColumn {
  return sweep.columns[column] as SweepColumn;
}

/** Each curve by ascending abscissa; points that failed are left out. */
function seriesOf(sweep: Sweep, ordinate: Ordinate, over: Over): Series[] {
  const x = columnOf(sweep, over.abscissa),
    y = columnOf(sweep, ordinate);
  const { names, of_row } = sweep.curves[over.abscissa.curves] ?? { names: [], of_row: [] };
  const points: [number, number][][] = names.map(() => []);
  of_row.forEach((curve, row) => {
    const at = over.inverse ? 1 / (x.values[row] ?? NaN) : (x.values[row] ?? NaN);
    const value = y.values[row] ?? NaN;
    if (Number.isFinite(at) && Number.isFinite(value)) points[curve]?.push([at, value]);
  });
  return names
    .map((name, curve): Series => {
      const sorted = (points[curve] ?? []).sort(([a], [b]) => a - b);
      return {
        name: name || y.name,
        x: sorted.map(([at]) => at),
        y: sorted.map(([, value]) => value),
        draw: x.categories.length > 0 ? 'bars' : 'line_and_points',
        low: [],
        high: [],
        reference: false,
        place: curve,
      };
    })
    .filter((series) => series.x.length > 0);
}

export function sweepPlot(sweep: Sweep, ordinate: Ordinate, over: Over): Plot {
  const x = columnOf(sweep, over.abscissa),
    y = columnOf(sweep, ordinate);
  const inverse = (text: string): string => (over.inverse && text !== '' ? `1/${text}` : text);
  const named = x.categories.length > 0;
  return {
    title: ordinate.title,
    kind: 'xy',
    x: {
      label: inverse(/\s/.test(x.name) && over.inverse ? `(${x.name})` : x.name),
      unit: inverse(x.unit),
      log: over.log,
      categories: x.categories,
    },
    y: { label: y.name, unit: y.unit, log: ordinate.log && !named, categories: [] },
    series: seriesOf(sweep, ordinate, over),
    marks: [],
    note: '',
  };
}
