/** Comma-separated values by RFC 4180. */
import { el } from './dom';
import { exact } from './format';
import type { Num } from './data';

function field(value: string | Num): string {
  const text = exact(value);
  return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

export function csv(rows: (string | Num)[][]): string {
  return rows.map((row) => row.map(field).join(',') + '\r\n').join('');
}

/** A name that every file system takes. */
export function fileName(title: string, ending: string): string {
  const plain = title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60);
  return `${plain || 'bondstatic'}.${ending}`;
}

export function save(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  el('a', { href: address, download: name }).click();
  // The browser reads the blob after this turn of the event loop.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

export function saveText(text: string, type: string, name: string): void {
  save(new Blob([text], { type: `${type};charset=utf-8` }), name);
}
