/** The page around the scene: what it shows is what it was told. */
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openReport, report } from './page.mjs';
import { parsedCsv } from './parsed.mjs';
import { inSight, plotsOf, rounded, told } from './shown.mjs';

async function tablesAsTold(page, runs) {
  for (const [index, run] of runs.entries()) {
    const shown = await page.locator(`.column[data-run="${index}"] .table`).evaluateAll((tables) =>
      tables.map((table) => ({
        title: table.querySelector('caption').textContent,
        columns: [...table.querySelectorAll('thead th')].map((cell) => cell.textContent),
        rows: [...table.querySelectorAll('tbody tr')].map((row) =>
          [...row.children].map((cell) => ({ text: cell.textContent, title: cell.title })),
        ),
      })),
    );
    assert.deepEqual(
      shown.map(({ title }) => title),
      run.tables.map(({ title }) => title),
    );
    for (const [t, table] of run.tables.entries()) {
      if (table.columns.some((name) => name !== '')) assert.deepEqual(shown[t].columns, table.columns);
      assert.equal(shown[t].rows.length, table.rows.length);
      for (const [r, row] of table.rows.entries())
        for (const [c, value] of row.entries()) {
          const cell = shown[t].rows[r][c];
          if (value === null) assert.equal(cell.text, '–');
          else if (typeof value === 'string') assert.equal(cell.text, value);
          else {
            assert.equal(Number(cell.title), value);
            assert.ok(
              Number(cell.text) === value || Number(cell.text) === rounded(value),
              `${cell.text} is ${value}`,
            );
          }
        }
    }
  }
}

for (const name of ['press.html', 'beam.html', 'all.html', 'hostile.html'])
  describe(name, () => {
    let opened, data;
    before(async () => {
      opened = await openReport(report(name));
      data = await told(opened.page);
    });
    after(() => opened.close());

    test('opens and is scrolled through without a problem', async () => {
      const { page, problems } = opened;
      for (const section of await page.locator('main > section').all())
        await section.scrollIntoViewIfNeeded();
      await page.waitForTimeout(500);
      assert.deepEqual(problems, []);
      assert.equal(await page.locator('.problem').count(), 0);
    });

    test('tables show the values that the page was told', () => tablesAsTold(opened.page, data.runs));

    test('each plot is there under its title', async () => {
      for (const [index, run] of data.runs.entries())
        assert.deepEqual(
          await plotsOf(opened.page, index).locator('.plot-title').allTextContents(),
          [...run.plots, ...(run.sweep?.ordinates ?? [])].map(({ title }) => title),
        );
    });

    test('warnings, notes and the case are shown as they are', async () => {
      for (const [index, run] of data.runs.entries()) {
        const texts = (where) => opened.page.locator(where).allTextContents();
        const top = data.runs.length === 1 ? '#top' : `#top [data-run="${index}"]`;
        assert.deepEqual(await texts(`${top} .warnings li`), run.warnings);
        assert.deepEqual(await texts(`${top} .notes li`), run.notes);
        assert.deepEqual(
          await texts(`#case [data-run="${index}"] code`),
          run.resolved_case === '' ? [] : [run.resolved_case],
        );
      }
    });

    test('headings come in order and each section has its anchor', async () => {
      const levels = await opened.page
        .locator('h1, h2, h3, h4')
        .evaluateAll((all) => all.map((one) => Number(one.tagName[1])));
      assert.equal(levels[0], 1);
      levels
        .slice(1)
        .forEach((level, i) => assert.ok(level <= levels[i] + 1, `h${level} after h${levels[i]}`));
      for (const link of await opened.page.locator('header nav a').all())
        assert.equal(await opened.page.locator(await link.getAttribute('href')).count(), 1);
    });
  });

describe('tables', () => {
  let page, close, run;
  before(async () => {
    ({ page, close } = await openReport(report('beam.html')));
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    run = (await told(page)).runs[0];
  });
  after(() => close());

  test('are sorted by a click on a header, and by a third one as they were', async () => {
    const t = run.tables.findIndex(({ columns, rows }) =>
      columns.some(
        (name, c) =>
          name !== '' &&
          rows.length > 2 &&
          rows.every((row) => typeof row[c] === 'number') &&
          new Set(rows.map((row) => row[c])).size > 2,
      ),
    );
    assert.ok(t >= 0, 'a table of numbers to sort');
    const { rows, columns } = run.tables[t];
    const c = columns.findIndex(
      (_, i) =>
        rows.every((row) => typeof row[i] === 'number') && new Set(rows.map((row) => row[i])).size > 2,
    );
    const table = page.locator('.table').nth(t),
      header = table.locator('thead th').nth(c);
    const values = async () =>
      (
        await table
          .locator('tbody tr')
          .evaluateAll((lines, column) => lines.map((line) => line.children[column].title), c)
      ).map(Number);
    const as = rows.map((row) => row[c]),
      sorted = [...as].sort((a, b) => a - b);
    for (const [order, expected] of [
      ['ascending', sorted],
      ['descending', [...sorted].reverse()],
      ['none', as],
    ]) {
      await header.locator('button').click();
      assert.equal(await header.getAttribute('aria-sort'), order);
      assert.deepEqual(await values(), expected);
    }
  });

  test('are copied as CSV with all digits', async () => {
    for (const [t, table] of run.tables.entries()) {
      const tool = page.locator('.table').nth(t);
      await tool.getByRole('button', { name: /^Copy the table/ }).click();
      await tool.getByText('copied').waitFor();
      const rows = parsedCsv(await page.evaluate(() => navigator.clipboard.readText()));
      assert.deepEqual(rows[0], table.columns);
      assert.deepEqual(
        rows
          .slice(1)
          .map((row, r) =>
            row.map((text, c) => (typeof table.rows[r][c] === 'number' ? Number(text) : text)),
          ),
        table.rows.map((row) => row.map((value) => value ?? '')),
      );
    }
  });
});

test('a hostile title is text', async () => {
  const { page, problems, close } = await openReport(report('hostile.html'));
  try {
    const title = '</script><script>alert(1)</script>';
    assert.equal(await page.locator('h1').textContent(), title);
    assert.equal(await page.title(), title);
    assert.equal(await page.locator('main script, header script, main img').count(), 0);
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
});

describe('several runs', () => {
  test('stand side by side on a wide screen, and the bar chooses which', async () => {
    const { page, problems, close } = await openReport(report('all.html'));
    try {
      const { runs } = await told(page);
      const bar = page.locator('header .runs button');
      assert.equal(await bar.count(), runs.length);
      for (const section of await page.locator('main > section').all()) {
        const columns = section.locator('.column:visible');
        assert.equal(await columns.count(), 2);
        const [a, b] = [await columns.nth(0).boundingBox(), await columns.nth(1).boundingBox()];
        assert.equal(a.y, b.y);
        assert.ok(b.x >= a.x + a.width);
      }
      const shown = () =>
        page.locator('#top .column:visible').evaluateAll((all) => all.map((one) => Number(one.dataset.run)));
      await bar.nth(0).click();
      assert.deepEqual(await shown(), [1]);
      await bar.nth(1).click();
      assert.deepEqual(await shown(), [1], 'one run always stays');
      await bar.nth(runs.length - 1).click();
      assert.deepEqual(await shown(), [1, runs.length - 1].slice(runs.length === 2 ? 1 : 0));
      assert.deepEqual(problems, []);
    } finally {
      await close();
    }
  });

  test('stand below each other on a narrow one', async () => {
    const { page, close } = await openReport(report('all.html'), { width: 400, height: 800 });
    try {
      const columns = page.locator('#top .column:visible');
      const [a, b] = [await columns.nth(0).boundingBox(), await columns.nth(1).boundingBox()];
      assert.ok(b.y >= a.y + a.height);
    } finally {
      await close();
    }
  });
});

for (const name of ['beam.html', 'all.html', 'hostile.html'])
  test(`${name} needs no sideways scrolling at 360 pixels`, async () => {
    const { page, close } = await openReport(report(name), { width: 360, height: 740 });
    try {
      for (const section of await page.locator('main > section').all())
        await section.scrollIntoViewIfNeeded();
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
    } finally {
      await close();
    }
  });

test('on paper: light whatever the screen is, unfolded, without what is only for a screen', async () => {
  const { page, problems, close } = await openReport(report('beam.html'), { colorScheme: 'dark' });
  try {
    const figure = page.locator('figure.plot:has(.uplot)').first();
    await inSight(figure);
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    await figure.locator('.printed').waitFor();
    for (const where of ['header.bar', '.tools', '.uplot'])
      assert.equal(await page.locator(where).filter({ visible: true }).count(), 0, where);
    assert.deepEqual(
      await page.locator('#case details').evaluateAll((all) => all.map((one) => one.open)),
      (await told(page)).runs.filter((run) => run.resolved_case !== '').map(() => true),
    );
    const corner = await figure
      .locator('.printed')
      .evaluate((canvas) => [...canvas.getContext('2d').getImageData(0, 0, 1, 1).data]);
    assert.deepEqual(corner, [255, 255, 255, 255]);
    await page.emulateMedia({ media: 'screen', colorScheme: 'dark' });
    await page.locator('header.bar').waitFor();
    assert.equal(await page.locator('.printed').count(), 0);
    assert.equal(await page.locator('#case details[open]').count(), 0);
    const pdf = await page.pdf({ format: 'A4', preferCSSPageSize: true });
    assert.equal(pdf.subarray(0, 5).toString(), '%PDF-');
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
});

test('a file that is not whole says so', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'bondstatic-report-'));
  try {
    const whole = await readFile(report('press.html'), 'utf8');
    const cut = whole.replace(/(id="page-data"[^>]*>)[^<]*/, '$1{"version":');
    assert.notEqual(cut, whole);
    await writeFile(join(folder, 'cut.html'), cut);
    const { page, close } = await openReport(join(folder, 'cut.html'));
    try {
      assert.match(await page.locator('.problem').innerText(), /could not be shown[^]*JSON/);
    } finally {
      await close();
    }
  } finally {
    await rm(folder, { recursive: true });
  }
});
