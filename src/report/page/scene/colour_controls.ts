/** By which column a kind of thing is coloured, over which range, and which of it a threshold leaves. */
import { button, el } from '../dom';
import { plainColouring, type Colouring } from './paint';
import type { Show } from './show';
import { choiceName, isSigned, type Choice, type Kind } from './values';
import { check, group, line, numberField, select } from './widgets';
import { said } from './words';

function choices(show: Show, kind: Kind): Choice[] {
  return show.values.columns(kind).flatMap((column, i) => {
    if (!show.scene.states.some((state) => state[kind][i])) return [];
    const components = column.components === 3 ? ([-1, 0, 1, 2] as const) : ([-1] as const);
    return components.map((component) => ({ kind, column: i, component }));
  });
}

export function colourControls(show: Show, kind: Kind): { box: HTMLElement; refresh: () => void } {
  const words = kind === 'bond' ? 'bonds' : 'particles';
  const all = choices(show, kind);
  const change = (what: Partial<Colouring>) => {
    Object.assign(show[kind], what);
    void show.paint(kind);
  };
  const low = numberField(`${words}: lowest value of the colours`, (value) => change({ low: value }));
  const high = numberField(`${words}: highest value of the colours`, (value) => change({ high: value }));
  const least = numberField(`${words}: hide below`, (value) => change({ least: value }));
  const most = numberField(`${words}: hide above`, (value) => change({ most: value }));
  const clear = () => [low, high, least, most].forEach((field) => field.clear());
  const key = (choice: Choice | null) => (choice ? `${choice.column}.${choice.component}` : '');
  const unit = (choice: Choice) =>
    show.values.column(choice).unit ? ` (${show.values.column(choice).unit})` : '';
  const options: [string, string][] = all.map((c) => [
    key(c),
    choiceName(show.values.column(c), c) + unit(c),
  ]);
  const take = (value: string) => {
    const { over, tails, log } = show[kind];
    clear();
    show[kind] = { ...plainColouring(), over, tails, log, choice: all.find((c) => key(c) === value) ?? null };
    void show.paint(kind);
  };
  const label = kind === 'bond' ? 'Bonds' : 'Particles';
  const column = select(
    label,
    [['', 'plain'], ...options],
    key(show[kind].choice),
    take,
    `Colour of ${words}`,
  );
  const several = show.scene.states.length > 1;
  const over = check('range of this state only', false, (on) => change({ over: on ? 'state' : 'load case' }));
  const byTens = check('by powers of ten', false, (log) => change({ log }));
  const detail = group(
    `Range and threshold of ${words}`,
    false,
    line('Colours from ', low.row, ' to ', high.row),
    check('leave out 2 % at either end', false, (tails) => change({ tails })),
    byTens,
    ...(several ? [over] : []),
    line('Hide below ', least.row, ' above ', most.row),
    line(
      button('Automatic', `${words}: automatic range, no threshold`, () => {
        clear();
        change({ low: null, high: null, least: null, most: null });
      }),
    ),
  );
  const refresh = () => {
    const legend = show.legends.find((one) => one.title.startsWith(kind === 'bond' ? 'Bonds' : 'Particles'));
    low.suggest(legend ? said(legend.low) : '');
    high.suggest(legend ? said(legend.high) : '');
    detail.hidden = !legend;
    const { choice } = show[kind];
    byTens.hidden = !choice || isSigned(show.values.column(choice), choice);
  };
  return { box: el('div', {}, column, detail), refresh };
}
