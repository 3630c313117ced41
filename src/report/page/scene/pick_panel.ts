/** Clicking or tapping a thing tells its number, its place and all that is known of it in this state. */
import { button, el } from '../dom';
import type { Show } from './show';
import { fixedInWords, withUnit } from './words';

/** What single precision holds. */
const digits = 7;

type Row = [name: string, value: string];

async function valuesOf(show: Show): Promise<Row[]> {
  const { picked, state, values } = show;
  if (!picked) return [];
  const rows: Row[] = [];
  for (const [i, column] of values.columns(picked.kind).entries()) {
    const all = await values.all(picked.kind, i, state);
    if (!all) continue;
    for (let c = 0; c < column.components; ++c) {
      const value = all[picked.row * column.components + c] ?? NaN;
      const name = column.components === 3 ? `${column.name} ${'xyz'[c]}` : column.name;
      if (column.name === 'fixed') rows.push([name, fixedInWords(value)]);
      else
        rows.push([
          name,
          withUnit(value, Number.isNaN(value) ? '' : column.unit, column.is_whole ? 15 : digits),
        ]);
    }
  }
  return rows;
}

function about(show: Show): Row[] {
  const { picked, model, scene } = show;
  if (!picked) return [];
  const unit = scene.length_unit;
  if (picked.kind === 'particle') {
    const at = model.position(picked.row);
    return [
      ...at.map((x, c): Row => ['xyz'[c] as string, withUnit(x, unit, digits)]),
      ['radius', withUnit(model.radius(picked.row), unit, digits)],
    ];
  }
  const ends = [0, 1].map((end) => model.ends[picked.row * 2 + end] as number);
  const [a, b] = ends.map((row) => model.position(row)) as [
    [number, number, number],
    [number, number, number],
  ];
  const length = Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  return [
    ['between particles', ends.map((row) => String(model.particleId[row])).join(' and ')],
    ...a.map((x, c): Row => [`middle ${'xyz'[c]}`, withUnit((x + (b[c] as number)) / 2, unit, digits)]),
    ['distance of centres', withUnit(length, unit, digits)],
  ];
}

export class PickPanel {
  readonly box = el('section', { class: 'scene-picked', 'aria-live': 'polite' });
  private shown_ = '';

  constructor(private show_: Show) {
    this.box.hidden = true;
  }

  async refresh(): Promise<void> {
    const { picked, state, model, scene } = this.show_;
    const key = picked ? `${picked.kind} ${picked.row} ${scene.states.indexOf(state)}` : '';
    if (key === this.shown_) return;
    this.shown_ = key;
    this.box.hidden = !picked;
    if (!picked) return;
    const rows = [...about(this.show_), ...(await valuesOf(this.show_))];
    if (key !== this.shown_) return;
    const id = picked.kind === 'particle' ? model.particleId[picked.row] : model.bondId[picked.row];
    const close = button('×', 'Close (Esc)', () => this.show_.pick(null));
    this.box.replaceChildren(
      el('header', {}, el('strong', {}, `${picked.kind === 'particle' ? 'Particle' : 'Bond'} ${id}`), close),
      el(
        'table',
        {},
        el(
          'tbody',
          {},
          ...rows.map(([name, value]) => el('tr', {}, el('th', { scope: 'row' }, name), el('td', {}, value))),
        ),
      ),
      el('p', {}, `Seven digits: the page holds single precision.`),
    );
  }
}
