/** What goes wrong is said in the page: a reader does not look into the console. */
import { el } from './dom';

let box: HTMLElement | undefined;

export function tellProblem(what: unknown): void {
  const text = what instanceof Error ? what.message : String(what);
  if (!box) {
    box = el(
      'section',
      { class: 'problem', role: 'alert' },
      el('h2', {}, 'A part of this page could not be shown'),
    );
    document.body.prepend(box);
  }
  box.append(el('p', {}, text));
}

/** First of all, so that nothing that follows fails unseen. */
export function watchProblems(): void {
  window.addEventListener('error', (event) => {
    // Browsers report so that a size that a plot took is looked at one frame later; nothing is wrong then.
    if (!event.message.startsWith('ResizeObserver loop')) tellProblem(event.error ?? event.message);
  });
  window.addEventListener('unhandledrejection', (event) => tellProblem(event.reason));
}
