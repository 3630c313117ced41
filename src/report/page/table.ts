/** A table of results: sorted by a click on a header, copied as CSV, each number whole in its tooltip. */
import { csv } from './csv';
import { button, el } from './dom';
import { exact, shown } from './format';
import type { Num, Table } from './data';

type Cell = string | Num;

/** Letters from which on a cell is given room to wrap in. */
const sentence = 24;

type Order = 'none' | 'ascending' | 'descending';

const following: Record<Order, Order> = { none: 'ascending', ascending: 'descending', descending: 'none' };

/** Numbers before text, and cells without a value last whichever way it is sorted. */
function compared(a: Cell, b: Cell, order: Order): number {
  if (a === null || b === null) return a === b ? 0 : a === null ? 1 : -1;
  const sign = order === 'descending' ? -1 : 1;
  if (typeof a === 'number' && typeof b === 'number') return sign * (a - b);
  if (typeof a === 'string' && typeof b === 'string')
    return sign * a.localeCompare(b, 'en', { numeric: true });
  return typeof a === 'number' ? -1 : 1;
}

function isNumeric(table: Table, column: number): boolean {
  const cells = table.rows.map((row) => row[column] ?? null).filter((cell) => cell !== null);
  return cells.length > 0 && cells.every((cell) => typeof cell === 'number');
}

function bodyCell(cell: Cell, first: boolean, numeric: boolean): HTMLTableCellElement {
  const made = first && typeof cell === 'string' ? el('th', { scope: 'row' }) : el('td');
  if (typeof cell === 'string') {
    made.textContent = cell;
    if (cell.length > sentence) made.className = 'sentence';
  } else {
    if (numeric) made.className = 'number';
    made.textContent = shown(cell);
    if (cell === null) made.setAttribute('aria-label', 'no value');
    else made.title = exact(cell);
  }
  return made;
}

async function copy(text: string, told: HTMLElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    told.textContent = 'copied';
  } catch {
    told.textContent = 'the browser did not let it be copied';
  }
  setTimeout(() => (told.textContent = ''), 2500);
}

function header(
  table: Table,
  numeric: boolean[],
  sorted: (column: number, order: Order) => void,
): HTMLTableSectionElement {
  const cells = table.columns.map((name, column) => {
    const cell = el('th', { scope: 'col', 'aria-sort': 'none' });
    if (numeric[column]) cell.className = 'number';
    const sort = el('button', { type: 'button', class: 'sort' }, name);
    sort.addEventListener('click', () => {
      const order = following[cell.getAttribute('aria-sort') as Order];
      for (const other of cells) other.setAttribute('aria-sort', 'none');
      cell.setAttribute('aria-sort', order);
      sorted(column, order);
    });
    cell.append(sort);
    return cell;
  });
  return el('thead', {}, el('tr', {}, ...cells));
}

export function tableOf(table: Table): HTMLElement {
  const body = el('tbody');
  const numeric = table.columns.map((_, column) => isNumeric(table, column));
  const lines = table.rows.map((row) => ({
    row,
    line: el(
      'tr',
      {},
      ...table.columns.map((_, i) => bodyCell(row[i] ?? null, i === 0, numeric[i] === true)),
    ),
  }));
  const fill = (column: number, order: Order): void => {
    const ordered =
      order === 'none'
        ? lines
        : [...lines].sort((a, b) => compared(a.row[column] ?? null, b.row[column] ?? null, order));
    body.replaceChildren(...ordered.map(({ line }) => line));
  };
  fill(0, 'none');

  const told = el('span', { class: 'told', role: 'status' });
  const asCsv = (): string => csv([table.columns, ...table.rows]);
  const tools = el(
    'span',
    { class: 'tools' },
    told,
    button('Copy CSV', `Copy the table “${table.title}” as CSV`, () => void copy(asCsv(), told)),
  );
  const content = el('table', {}, el('caption', {}, table.title), body);
  // A list of names and values needs no header.
  if (table.columns.some((name) => name !== '')) body.before(header(table, numeric, fill));
  const box = el(
    'div',
    { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': table.title },
    content,
  );
  const shape =
    (table.columns.length <= 2 ? ' facts-of' : '') +
    (table.columns.length > 5 ? ' wide' : '') +
    (table.rows.length > 30 ? ' long' : '');
  const made = el('div', { class: `table${shape}` }, tools, box);
  if (table.note !== '') made.append(el('p', { class: 'note' }, table.note));
  return made;
}
