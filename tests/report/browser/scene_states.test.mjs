/** Models of several states and load cases, of many particles, and where nothing can be drawn. */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openReport, report } from './page.mjs';
import { canvas, caption, columns, different, opened, picture, played, says, seen, still } from './scene_page.mjs';

describe('a beam that cracks', () => {
  let page, problems, close;
  before(async () => ({ page, problems, close } = await opened('beam.html', { width: 360, height: 760 })));
  after(async () => {
    await close?.();
    assert.deepEqual(problems, []);
  });
  const label = () => page.locator('.scene-state').textContent();
  const all = async () => Number(/of (\d+)/.exec(await label())[1]);
  const broken = async () =>
    Number((/([\d,]+) broken bonds/.exec(await caption(page)) ?? ['', '0'])[1].replace(',', ''));

  test('fits a narrow screen', async () => {
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
    assert.ok((await seen(page, await picture(page))).marked > 5_000);
  });

  test('each state has lost the bonds that bonds.csv says', async () => {
    const { break_step } = await columns('beam/bonds.csv');
    const states = await all();
    const slider = page.getByLabel('state', { exact: true });
    const told = await page.evaluate(
      () => JSON.parse(document.getElementById('page-data').textContent).runs[0].scene.states,
    );
    const pictures = new Set();
    await slider.focus();
    await page.keyboard.press('Home');
    for (let i = 0; i < states; ++i) {
      await page
        .locator('.scene-state')
        .filter({ hasText: new RegExp(`^${i + 1} of`) })
        .waitFor();
      const expected = break_step.filter((step) => step > 0 && step <= told[i].step).length;
      await page.waitForFunction((number) => {
        const text = document.querySelector('.scene-caption').textContent;
        return number === 0 ? !text.includes('broken') : text.includes(`${number} broken bonds`);
      }, expected);
      pictures.add((await picture(page)).toString('base64'));
      await slider.focus();
      await page.keyboard.press('ArrowRight');
    }
    assert.ok(states >= 3 && pictures.size === states, `${pictures.size} pictures of ${states} states`);
  });

  test('plays from the first state to the last and stops there', async () => {
    const states = await all();
    assert.deepEqual(await played(page), Array.from({ length: states }, (_, i) => i + 1));
    assert.match(await label(), new RegExp(`^${states} of`));
    const { break_step } = await columns('beam/bonds.csv');
    await page.waitForFunction(() =>
      document.querySelector('.scene-caption').textContent.includes('broken bonds'),
    );
    assert.equal(await broken(), break_step.filter((step) => step > 0).length);
  });

  test('broken bonds are drawn on demand', async () => {
    const without = await picture(page);
    await page.getByLabel('broken bonds, red and dashed').check();
    await says(page, 'broken bonds red and dashed');
    const [hidden, drawn] = [await seen(page, without), await seen(page, await picture(page))];
    assert.ok(drawn.red > hidden.red, `${hidden.red} and ${drawn.red} red pixels`);
    await page.getByLabel('broken bonds, red and dashed').uncheck();
    await says(page, 'broken bonds hidden');
  });
});

describe('a cantilever on its way to rest', () => {
  let page, problems, close;
  before(async () => ({ page, problems, close } = await opened('moving.html', { width: 1000, height: 560 })));
  after(async () => {
    await close?.();
    assert.deepEqual(problems, []);
  });
  const shown = (text) => page.locator('.scene-state').filter({ hasText: text }).waitFor({ timeout: 60_000 });
  const told = () =>
    page.evaluate(() => JSON.parse(document.getElementById('page-data').textContent).runs[0].scene.states);

  for (const name of ['up', 'down'])
    test(`load case ${name} is played in time`, async () => {
      const states = (await told()).filter((state) => state.load_case === name);
      const { time, kinetic } = await columns(`moving/${name}/history.csv`);
      assert.ok(states.length > 10, `${states.length} states`);
      await page.getByLabel('Load case', { exact: true }).selectOption(name);
      await shown(new RegExp(`^${states.length} of ${states.length}: time .*, at rest$`));
      await page.getByLabel('state', { exact: true }).focus();
      await page.keyboard.press('Home');
      const pictures = new Set();
      for (const [i, { step, label }] of states.entries()) {
        const row = time.indexOf(step);
        assert.ok(row >= 0 && (i === 0 || step > states[i - 1].step), `time ${step}`);
        const [, at, energy] = /^time (\S+) s, kinetic (\S+) J/.exec(label);
        assert.ok(Math.abs(at - step) <= 5e-4 * step, label);
        assert.ok(Math.abs(energy - kinetic[row]) <= 5e-4 * kinetic[row], label);
        await shown(`${i + 1} of ${states.length}: ${label}`);
        if (i < 6) pictures.add((await picture(page)).toString('base64'));
        await page.getByLabel('state', { exact: true }).focus();
        await page.keyboard.press('ArrowRight');
      }
      assert.equal(pictures.size, 6, 'the beam moves');
      assert.deepEqual(await played(page), Array.from(states, (_, i) => i + 1));
      await shown(/, at rest$/);
    });
});

test('load cases are chosen by name', async () => {
  const { page, problems, close } = await opened('loads.html', { width: 1000, height: 560 });
  try {
    const told = await page.evaluate(
      () => JSON.parse(document.getElementById('page-data').textContent).runs[0].scene.states,
    );
    const names = [...new Set(told.map((state) => state.load_case))];
    const choose = page.getByLabel('Load case', { exact: true });
    assert.deepEqual(await choose.locator('option').allTextContents(), names);
    assert.ok(names.length > 1);
    const captions = new Set();
    for (const name of names) {
      await choose.selectOption(name);
      await page.waitForTimeout(50);
      await still(page);
      captions.add(await caption(page));
    }
    assert.equal(captions.size, names.length, 'each load case has forces of its own');
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
});

describe('a large packing', () => {
  test('turns with a part of it, and rests whole', async () => {
    const { page, problems, close } = await opened('large.html', { width: 1000, height: 560 });
    try {
      const data = await page.locator('#page-data').textContent();
      const told = JSON.parse(data).runs[0].scene;
      assert.ok(told.all_particles >= 100_000 && told.all_bonds >= 400_000, 'a large model');
      const counts = [told.all_particles, told.all_bonds].map((number) => number.toLocaleString('en'));
      const text = await caption(page);
      assert.ok(text.startsWith(`${counts[0]} particles, ${counts[1]} bonds.`), text);
      const first = await picture(page);
      assert.ok((await seen(page, first)).marked > 20_000);
      const box = await canvas(page).boundingBox();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await page.mouse.down();
      for (let i = 1; i <= 12; ++i)
        await page.mouse.move(box.x + box.width / 2 + 10 * i, box.y + box.height / 2);
      await page.mouse.up();
      await still(page);
      assert.equal(await page.locator('.scene-grid').getAttribute('data-part'), '1');
      different(await picture(page), first);
      assert.deepEqual(problems, []);
    } finally {
      await close();
    }
  });
});

test('a browser without WebGL is told so, and the page goes on', async () => {
  const { page, problems, close } = await openReport(report('press.html'));
  try {
    await page.addInitScript(() => {
      const context = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return /webgl/.test(kind) ? null : context.call(this, kind, ...rest);
      };
    });
    await page.reload();
    await page.locator('.scene-message').filter({ hasText: 'no WebGL 2' }).waitFor();
    assert.equal(await page.locator('.scene-canvas').count(), 0);
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
});
