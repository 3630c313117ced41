/** Where a report shows what. */

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
