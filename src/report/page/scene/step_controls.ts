/** Which load case and which of its states: chosen, stepped through, or played. */
import { button, el } from '../dom';
import { tellProblem } from '../problems';
import type { State } from '../data';
import type { Show } from './show';
import { select } from './widgets';

/** Between two of so many states while playing, in milliseconds: a long series takes half a minute. */
const pace = (states: number) => Math.min(450, 30_000 / states);

/** "3 of 9: 20 broken" */
function place(at: number, states: State[]): string {
  const label = states[at]?.label;
  return `${at + 1} of ${states.length}${label ? `: ${label}` : ''}`;
}

export function stepControls(show: Show): HTMLElement | null {
  const { states } = show.scene;
  if (states.length < 2) return null;
  const cases = [...new Set(states.map((state) => state.load_case))];
  const input = el('input', { type: 'range', min: '0', step: '1', 'aria-label': 'state' });
  const label = el('output', { class: 'scene-state' });
  let playing = 0;

  const go = async (state: State) => {
    const inCase = states.filter((one) => one.load_case === state.load_case);
    const at = inCase.indexOf(state);
    input.max = String(inCase.length - 1);
    input.value = String(at);
    input.setAttribute('aria-valuetext', state.label);
    label.textContent = place(at, inCase);
    bar.hidden = inCase.length < 2;
    await show.go(state);
  };
  const goTo = (at: number) => {
    const inCase = show.statesOfCase();
    const state = inCase[Math.min(inCase.length - 1, Math.max(0, at))];
    return state ? go(state) : Promise.resolve();
  };
  const stop = () => {
    clearTimeout(playing);
    playing = 0;
    play.textContent = 'Play';
    play.setAttribute('aria-pressed', 'false');
  };
  const onward = async () => {
    const at = Number(input.value);
    const last = Number(input.max);
    if (at >= last) return stop();
    const started = performance.now();
    await goTo(at + 1);
    if (playing)
      playing = window.setTimeout(
        () => onward().catch(tellProblem),
        Math.max(0, pace(last + 1) - (performance.now() - started)),
      );
  };
  const play = button('Play', 'Play the states', () => {
    if (playing) return stop();
    play.textContent = 'Pause';
    play.setAttribute('aria-pressed', 'true');
    const first = Number(input.value) >= Number(input.max) ? goTo(0) : Promise.resolve();
    playing = window.setTimeout(() => first.then(onward).catch(tellProblem), pace(Number(input.max) + 1));
  });
  const jump = (by: number) => {
    stop();
    goTo(Number(input.value) + by).catch(tellProblem);
  };
  input.addEventListener('input', () => jump(0));
  const bar = el(
    'div',
    { class: 'scene-play' },
    play,
    button('‹', 'State before', () => jump(-1)),
    input,
    button('›', 'Next state', () => jump(1)),
  );
  const choose = select(
    'Load case',
    cases.map((name) => [name, name || 'unnamed']),
    show.state.load_case,
    (name) => {
      stop();
      const inCase = states.filter((state) => state.load_case === name);
      go(inCase[inCase.length - 1] as State).catch(tellProblem);
    },
  );
  const box = el('div', { class: 'scene-steps' }, ...(cases.length > 1 ? [choose] : []), bar, label);
  const inCase = show.statesOfCase();
  input.max = String(inCase.length - 1);
  input.value = String(inCase.indexOf(show.state));
  label.textContent = place(inCase.indexOf(show.state), inCase);
  bar.hidden = inCase.length < 2;
  return box;
}
