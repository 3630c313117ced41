/** Where a report shows what. */
import { readFile } from 'node:fs/promises';

/** What the page was told. */
export function told(page) {
  return page.evaluate(() => JSON.parse(document.getElementById('page-data').textContent));
}

/** As many digits as the page shows at most. */
export const rounded = (value) => Number(value.toPrecision(10));

export const plotsOf = (page, run) => page.locator(`#plots .column[data-run="${run}"] figure.plot`);

/** The plot's canvas has been drawn once the plot has been in sight. */
export async function inSight(figure) {
  await figure.scrollIntoViewIfNeeded();
  await figure.locator('canvas').first().waitFor();
}

/** Beside five busy processes a first download was seen not to come; why is not known. A reader would ask again. */
export async function downloaded(page, button) {
  let download = null;
  for (let asked = 0; !download && asked < 4; ++asked)
    [download] = await Promise.all([
      page.waitForEvent('download', { timeout: 15_000 }).catch(() => null),
      button.press('Enter'),
    ]);
  if (!download) throw new Error('four times asked, and no download');
  return { name: download.suggestedFilename(), content: await readFile(await download.path()) };
}

/** Moves the mouse to a place of the plotting area, given in fractions of it. */
export async function hover(page, figure, x, y) {
  const area = await figure.locator('.u-over').boundingBox();
  await page.mouse.move(area.x + x * area.width - 1, area.y + y * area.height);
  await page.mouse.move(area.x + x * area.width, area.y + y * area.height);
}

export const readRows = (figure) =>
  figure
    .locator('.readout:not([hidden]) tbody tr')
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
