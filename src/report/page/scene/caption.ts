/** What is seen, in words: under the picture, and for those who do not see it. */
import { count } from '../format';
import type { Show } from './show';
import { said } from './words';

function countWords(shown: number, all: number, what: string): string {
  return shown === all
    ? `${count(all)} ${what}`
    : `${count(shown)} of ${count(all)} ${what} chosen at random`;
}

export function caption(show: Show): string {
  const { scene, model } = show;
  const parts = [
    `${countWords(model.drawn, scene.all_particles, 'particles')}, ` +
      `${countWords(model.bonds, scene.all_bonds, 'bonds')}.`,
  ];
  if (show.showParticles && show.shrink !== 1)
    parts.push(`Particles at ${Math.round(show.shrink * 100)} % of their size.`);
  for (const legend of show.legends) {
    const ends = [legend.lowWord, legend.highWord].map((word) => (word ? ` (${word})` : ''));
    const by = legend.log ? ' by powers of ten' : '';
    parts.push(`${legend.title}${by} from ${said(legend.low)}${ends[0]} to ${said(legend.high)}${ends[1]}.`);
  }
  if (show.moves >= 0) {
    const name =
      scene.particle_columns[show.moves]?.name === 'displacement'
        ? 'Displacements'
        : scene.particle_columns[show.moves]?.name;
    parts.push(show.factor === 0 ? `${name} not drawn.` : `${name} x ${said(show.factor, 3)}.`);
  }
  if (show.broken > 0) {
    const how = show.isByBreak() ? 'drawn' : show.showBroken ? 'red and dashed' : 'hidden';
    parts.push(`${count(show.broken)} broken bonds ${how}.`);
  }
  for (const kind of ['particle', 'bond'] as const)
    if (show.hidden[kind] > 0) parts.push(`${count(show.hidden[kind])} ${kind}s hidden by the threshold.`);
  for (const note of show.notes) parts.push(`${note[0]?.toUpperCase()}${note.slice(1)}.`);
  return parts.join(' ');
}
