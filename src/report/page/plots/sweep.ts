/** The plots of a sweep, and what stands above them: over what they are drawn. */
import { el } from '../dom';
import { check, select } from '../scene/widgets';
import { plotOf } from './plot';
import { columnOf, sweepPlot, type Over } from './sweep_plot';
import type { Abscissa, Sweep } from '../data';

export function sweepOf(sweep: Sweep): HTMLElement {
  const plots = el('div', { class: 'plots' });
  const scales = el('span', { role: 'group', 'aria-label': 'scale of the abscissa' });
  let gone = new AbortController();
  const draw = (over: Over): void => {
    gone.abort();
    gone = new AbortController();
    const drawn = sweep.ordinates.filter(({ column }) => column !== over.abscissa.column);
    plots.replaceChildren(...drawn.map((one) => plotOf(sweepPlot(sweep, one, over), gone.signal)));
  };
  const choose = (abscissa: Abscissa): void => {
    const over: Over = { abscissa, log: abscissa.log, inverse: false };
    const set = (change: Partial<Over>): void => draw(Object.assign(over, change));
    const named = columnOf(sweep, abscissa).categories.length > 0;
    scales.replaceChildren(
      ...(named
        ? []
        : [
            check('log', over.log, (log) => set({ log })),
            check('1/x', over.inverse, (inverse) => set({ inverse })),
          ]),
    );
    draw(over);
  };
  const names = sweep.abscissae.map((one, i): [string, string] => [`${i}`, columnOf(sweep, one).name]);
  const chooser = select('over', names, '0', (i) => choose(sweep.abscissae[Number(i)] as Abscissa), 'abscissa');
  choose(sweep.abscissae[0] as Abscissa);
  return el('div', { class: 'sweep' }, el('div', { class: 'sweep-over' }, chooser, scales), plots);
}
