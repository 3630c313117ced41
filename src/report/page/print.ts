/**
 * Paper is white whatever the screen is: while the page is printed the root carries `data-print`, under which
 * page.css gives the light colours, and who draws by script is told to draw again.
 */
interface Printed {
  start: () => void;
  end: () => void;
}

const parts = new Set<Printed>();
let printing = false;

function start(): void {
  if (printing) return;
  printing = true;
  document.documentElement.dataset['print'] = '';
  for (const part of parts) part.start();
}

function end(): void {
  if (!printing) return;
  printing = false;
  delete document.documentElement.dataset['print'];
  for (const part of parts) part.end();
}

export function whenPrinted(part: Printed, gone?: AbortSignal): void {
  parts.add(part);
  gone?.addEventListener('abort', () => parts.delete(part));
}

export function watchPrint(): void {
  window.addEventListener('beforeprint', start);
  window.addEventListener('afterprint', end);
  matchMedia('print').addEventListener('change', (event) => (event.matches ? start() : end()));
  whenPrinted(casesOpen());
}

/** A folded case is of no use on paper. */
function casesOpen(): Printed {
  let opened: HTMLDetailsElement[] = [];
  return {
    start: () => {
      opened = [...document.querySelectorAll<HTMLDetailsElement>('#case details')].filter(
        (fold) => !fold.open,
      );
      for (const fold of opened) fold.open = true;
    },
    end: () => {
      for (const fold of opened) fold.open = false;
    },
  };
}
