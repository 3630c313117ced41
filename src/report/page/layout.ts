/** The page: header, and each section with a column for each run that is chosen. */
import { el } from './dom';
import { tellProblem } from './problems';
import { factsOf, messagesOf, sections } from './run_parts';
import type { PageData, Run } from './data';

/** So many runs are shown before anybody chooses: that many columns fit. */
const shownAtFirst = 2;

/** A run's letter, by which it is found again in each section. */
function letter(index: number): string {
  return index < 26 ? String.fromCharCode(65 + index) : String(index + 1);
}

function titleOf(run: Run): string {
  return run.title || run.folder;
}

/** A column of a section; empty where the run has nothing for it, so that columns stay aligned. */
function column(
  run: Run,
  index: number,
  heading: 'h2' | 'h3' | undefined,
  content: HTMLElement[],
): HTMLElement {
  const made = el('div', { class: 'column', 'data-run': String(index) });
  if (heading)
    made.append(el(heading, {}, el('span', { class: 'letter' }, letter(index)), ` ${titleOf(run)}`));
  made.append(...content);
  if (content.length === 0) made.append(el('p', { class: 'nothing' }, 'This run has nothing here.'));
  return made;
}

function intro(data: PageData): HTMLElement {
  const only = data.runs.length === 1 ? data.runs[0] : undefined;
  if (only)
    return el(
      'section',
      { id: 'top', class: 'intro' },
      el('h1', {}, titleOf(only)),
      el('p', { class: 'facts' }, `${factsOf(only)} · bondstatic ${data.version}`),
      ...messagesOf(only),
    );
  return el(
    'section',
    { id: 'top', class: 'intro' },
    el('h1', {}, `${data.runs.length} runs side by side`),
    el('p', { class: 'facts' }, `bondstatic ${data.version}`),
    el(
      'div',
      { class: 'columns' },
      ...data.runs.map((run, i) =>
        column(run, i, 'h2', [el('p', { class: 'facts' }, factsOf(run)), ...messagesOf(run)]),
      ),
    ),
  );
}

/** What goes wrong in one part leaves the others. */
function unlessItFails<T>(make: () => T): T | undefined {
  try {
    return make();
  } catch (error) {
    tellProblem(error);
    return undefined;
  }
}

function sectionsOf(data: PageData): HTMLElement[] {
  const many = data.runs.length > 1;
  return sections.flatMap(({ id, title, of }) => {
    const contents = data.runs.map((run) => unlessItFails(() => of(run)));
    if (contents.every((content) => !content)) return [];
    return [
      el(
        'section',
        { id, 'aria-labelledby': `${id}-title` },
        el('h2', { id: `${id}-title` }, title),
        el(
          'div',
          { class: 'columns' },
          ...data.runs.map((run, i) => {
            const content = contents[i];
            return column(run, i, many ? 'h3' : undefined, content ? [content] : []);
          }),
        ),
      ),
    ];
  });
}

/** Buttons that choose which runs are shown. */
function runBar(runs: Run[], main: HTMLElement): HTMLElement {
  const shown = runs.map((_, i) => i < shownAtFirst);
  const apply = (): void => {
    for (const one of main.querySelectorAll<HTMLElement>('.column'))
      one.hidden = !shown[Number(one.dataset['run'])];
    main.dataset['columns'] = String(Math.min(2, shown.filter(Boolean).length));
  };
  const choices = runs.map((run, i) => {
    const choice = el(
      'button',
      { type: 'button', 'aria-pressed': String(shown[i]), title: run.folder },
      el('span', { class: 'letter' }, letter(i)),
      ` ${run.kind}: ${titleOf(run)}`,
    );
    choice.addEventListener('click', () => {
      // One run always stays.
      if (shown[i] && shown.filter(Boolean).length === 1) return;
      shown[i] = !shown[i];
      choice.setAttribute('aria-pressed', String(shown[i]));
      apply();
    });
    return choice;
  });
  apply();
  return el('div', { class: 'runs', role: 'group', 'aria-label': 'runs that are shown' }, ...choices);
}

export function buildPage(data: PageData, body: HTMLElement): void {
  const parts = sectionsOf(data);
  const main = el('main', {}, intro(data), ...parts);
  const links = parts.map((part) =>
    el('a', { href: `#${part.id}` }, part.querySelector('h2')?.textContent ?? ''),
  );
  const header = el(
    'header',
    { class: 'bar' },
    el('a', { href: '#top', class: 'product' }, 'bondstatic'),
    el('nav', { 'aria-label': 'sections' }, ...links),
  );
  if (data.runs.length > 1) header.append(runBar(data.runs, main));
  body.prepend(header, main);
  document.title =
    data.runs.length === 1 && data.runs[0] ? titleOf(data.runs[0]) : `${data.runs.length} runs - bondstatic`;
  // What sticks to the top may take several lines; what is jumped to must not lie beneath it.
  new ResizeObserver(() =>
    document.documentElement.style.setProperty('--bar', `${header.offsetHeight}px`),
  ).observe(header);
}
