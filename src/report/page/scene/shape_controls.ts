/** What is shown and how large, how far displacements are drawn, and where the model is cut. */
import { button, el } from '../dom';
import type { Axis } from './model';
import type { Show } from './show';
import { check, group, line, select, slider } from './widgets';
import { said, withUnit } from './words';

export function showControls(show: Show): HTMLElement {
  const { model } = show;
  const percent = (value: number) => `${Math.round(value * 100)} %`;
  const apply = (what: Partial<Show>) => {
    Object.assign(show, what);
    show.applyShown();
  };
  const bonds =
    model.bonds === 0
      ? []
      : [
          check('bonds', show.showBonds, (on) => apply({ showBonds: on })),
          slider('Thickness', [0.05, 2, 0.05], show.thick, percent, (thick) => apply({ thick })).row,
        ];
  const broken = check('broken bonds, red and dashed', show.showBroken, (on) => {
    show.showBroken = on;
    void show.paint('bond');
  });
  const marks = show.marks.kinds.map((kind) =>
    check(kind.label, kind.shown, (on) => {
      kind.shown = on;
      void show.symbols();
    }),
  );
  return group(
    'Show',
    true,
    check('particles', show.showParticles, (on) => apply({ showParticles: on })),
    slider('Size', [0.05, 1, 0.05], show.shrink, percent, (shrink) => apply({ shrink })).row,
    ...bonds,
    ...(show.breakColumn() >= 0 ? [broken] : []),
    ...marks,
  );
}

/** The slider goes by powers of ten about the automatic factor. */
export function shapeControls(show: Show): { box: HTMLElement | null; refresh: () => void } {
  const columns = show.movable();
  if (columns.length === 0) return { box: null, refresh: () => {} };
  const set = (factor: number) => {
    show.factor = factor;
    show.applyFactor();
  };
  const about = () => Math.log10(show.automatic || 1);
  const text = () => (show.factor === 0 ? 'as it was' : `x ${said(show.factor, 3)}`);
  const scale = slider('Displacements', [-2, 1.5, 0.01], 0, text, (power) => set(10 ** (about() + power)));
  const column = select(
    'By',
    columns.map((i) => [`${i}`, show.scene.particle_columns[i]?.name ?? '']),
    `${show.moves}`,
    (value) => {
      show.moves = Number(value);
      void show.findScale().then(() => show.moveParticles());
    },
  );
  const box = group(
    'Deformed shape',
    true,
    scale.row,
    line(
      button('x 0', 'Displacements not drawn', () => set(0)),
      button('x 1', 'Displacements as they are', () => set(1)),
      button('Automatic', 'Displacements at the automatic scale', () => set(show.automatic)),
    ),
    ...(columns.length > 1 ? [column] : []),
  );
  return {
    box,
    refresh: () =>
      scale.set(show.factor > 0 ? Math.min(1.5, Math.max(-2, Math.log10(show.factor) - about())) : -2),
  };
}

export function cutControls(show: Show): HTMLElement {
  const { model, cut, scene } = show;
  const inUnits = (at: number, axis: Axis) => at * model.size + model.middle[axis] + scene.origin[axis];
  const spot = (part: number, axis: Axis) => model.low[axis] + part * (model.high[axis] - model.low[axis]);
  let part = 0.5;
  const apply = () => {
    if (cut.axis !== null) cut.at = spot(part, cut.axis);
    show.applyCut();
  };
  const text = () =>
    cut.axis === null ? '' : withUnit(inUnits(spot(part, cut.axis), cut.axis), scene.length_unit, 3);
  const where = slider('Position', [0, 1, 0.002], part, text, (value) => {
    part = value;
    apply();
  });
  const other = check('keep the other side', false, (flipped) => {
    cut.flipped = flipped;
    apply();
  });
  const details = el('div', {}, where.row, other);
  details.hidden = true;
  const axis = select(
    'Across',
    [
      ['', 'no cut'],
      ['0', 'x'],
      ['1', 'y'],
      ['2', 'z'],
    ],
    '',
    (value) => {
      cut.axis = value === '' ? null : (Number(value) as Axis);
      details.hidden = cut.axis === null;
      where.set(part);
      apply();
    },
  );
  return group('Cut', false, axis, details);
}
