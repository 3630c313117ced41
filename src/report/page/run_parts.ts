/** What of a run stands in which section of the page. */
import { showScene } from './scene/view';
import { el } from './dom';
import { count } from './format';
import { plotOf } from './plots/plot';
import { sweepOf } from './plots/sweep';
import { tellProblem } from './problems';
import { tableOf } from './table';
import type { Run } from './data';

export interface Section {
  id: string;
  title: string;
  /** undefined where the run has nothing for it */
  of(run: Run): HTMLElement | undefined;
}

function list(kind: string, title: string, texts: string[]): HTMLElement[] {
  if (texts.length === 0) return [];
  return [
    el(
      'aside',
      { class: kind, 'aria-label': title },
      el('strong', {}, texts.length === 1 ? title.replace(/s$/, '') : `${title} (${count(texts.length)})`),
      el('ul', {}, ...texts.map((text) => el('li', {}, text))),
    ),
  ];
}

/** "solve · 2,068 particles · 6,271 bonds · folder" */
export function factsOf(run: Run): string {
  const facts: string[] = [run.kind];
  if (run.scene)
    facts.push(`${count(run.scene.all_particles)} particles`, `${count(run.scene.all_bonds)} bonds`);
  facts.push(run.folder);
  return facts.join(' · ');
}

export function messagesOf(run: Run): HTMLElement[] {
  return [...list('warnings', 'Warnings', run.warnings), ...list('notes', 'Notes', run.notes)];
}

function model(run: Run): HTMLElement | undefined {
  if (!run.scene) return undefined;
  const host = el('div', { class: 'model' });
  const { scene } = run;
  // A scene needs its size, so it waits until it is seen; that of a run that nobody chooses is never built.
  const watcher = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      watcher.disconnect();
      showScene(host, scene, run.title || run.folder).catch((error: unknown) => {
        host.append(el('p', { class: 'nothing' }, 'The model could not be shown.'));
        tellProblem(error);
      });
    },
    { rootMargin: '200px' },
  );
  watcher.observe(host);
  return host;
}

/** The first table holds what was asked for. */
function results(run: Run): HTMLElement | undefined {
  return run.tables[0] && el('div', { class: 'stack' }, tableOf(run.tables[0]));
}

function plots(run: Run): HTMLElement | undefined {
  const parts: HTMLElement[] = [];
  if (run.plots.length > 0)
    parts.push(el('div', { class: 'plots' }, ...run.plots.map((plot) => plotOf(plot))));
  if (run.sweep) parts.push(sweepOf(run.sweep));
  return parts.length === 0 ? undefined : el('div', { class: 'stack' }, ...parts);
}

function tables(run: Run): HTMLElement | undefined {
  return run.tables.length < 2
    ? undefined
    : el('div', { class: 'tables' }, ...run.tables.slice(1).map(tableOf));
}

function caseText(run: Run): HTMLElement | undefined {
  if (run.resolved_case === '') return undefined;
  return el(
    'details',
    {},
    el('summary', {}, run.kind === 'calibrate' ? 'The case, calibrated' : 'The case, every default written out'),
    el('pre', { tabindex: '0' }, el('code', {}, run.resolved_case)),
  );
}

export const sections: Section[] = [
  { id: 'model', title: 'Model', of: model },
  { id: 'results', title: 'Results', of: results },
  { id: 'plots', title: 'Plots', of: plots },
  { id: 'tables', title: 'Tables', of: tables },
  { id: 'case', title: 'Case', of: caseText },
];
