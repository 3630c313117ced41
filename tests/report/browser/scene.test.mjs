/** The model in three dimensions: what is seen and told is what the files of results say. */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, describe, test } from 'node:test';
import { pngSize } from './parsed.mjs';
import {
  canvas, caption, columns, different, near, opened, panel, picture, press, same, says, seen, still,
} from './scene_page.mjs';

/** Clicks on a grid of spots until a thing of that kind is hit. */
async function pickA(page, kind) {
  const box = await canvas(page).boundingBox();
  for (let i = 0; i < 60; ++i) {
    const x = box.width * (0.4 + 0.2 * ((i * 0.618) % 1));
    await page.mouse.click(box.x + x, box.y + box.height * (0.45 + 0.15 * ((i * 0.7549) % 1)));
    const title = page.locator('.scene-picked:visible strong', { hasText: kind });
    if (
      await title.waitFor({ timeout: 400 }).then(
        () => true,
        () => false,
      )
    )
      return panel(page);
  }
  throw new Error(`no ${kind} was hit`);
}

describe('a packing under load', () => {
  let page, problems, close, first;
  before(async () => {
    ({ page, problems, close } = await opened('press.html', { width: 1000, height: 560 }));
    first = await picture(page);
  });
  after(async () => {
    await close?.();
    assert.deepEqual(problems, []);
  });

  test('is drawn, with tension red and compression blue, and told in words', async () => {
    const found = await seen(page, first);
    assert.ok(found.marked > 40_000, `${found.marked} pixels drawn`);
    assert.ok(found.colours > 500, `${found.colours} colours`);
    assert.ok(found.blue > 500, `${found.blue} blue pixels: pressed`);
    const text = await caption(page);
    assert.match(text, /2,068 particles, 6,271 bonds/);
    const { normal_force } = await columns('press/bonds.csv');
    const most = Math.max(...normal_force.map(Math.abs)).toPrecision(4);
    assert.ok(text.includes(`from -${most} (compression) to ${most} (tension)`), text);
    assert.equal(
      await canvas(page)
        .getAttribute('aria-label')
        .then((label) => label.includes(text)),
      true,
    );
  });

  test('another column gives other colours and another legend; plain gives none', async () => {
    const choose = page.getByLabel('Colour of bonds');
    const { energy } = await columns('press/bonds.csv');
    const option = await choose.locator('option', { hasText: /^energy/ }).getAttribute('value');
    await choose.selectOption(option);
    await says(page, /Bonds: energy/);
    different(await picture(page), first);
    const range = /energy[^.]*? from ([-\d.e]+) to ([-\d.e]+)\. /.exec(await caption(page));
    assert.ok(Math.abs(Number(range[2]) / Math.max(...energy) - 1) < 5e-4, range[0]);
    await choose.selectOption('');
    await page.locator('.scene-caption').filter({ hasNotText: 'Bonds:' }).waitFor();
    const plain = await seen(page, await picture(page));
    assert.equal(plain.red, 0);
    await choose.selectOption({
      label: await choose.locator('option', { hasText: /^normal_force/ }).textContent(),
    });
    await says(page, /Bonds: normal_force/);
    same(await picture(page), first);
  });

  test('a typed range is taken, and what is no number is refused', async () => {
    await page.getByText('Range and threshold of bonds').click();
    const high = page.getByLabel('bonds: highest value of the colours');
    await high.fill('0.5');
    await high.press('Enter');
    await says(page, /to 0\.5 \(tension\)/);
    await high.fill('much');
    await high.press('Enter');
    assert.equal(await high.getAttribute('aria-invalid'), 'true');
    assert.match(await caption(page), /to 0\.5 \(tension\)/);
    await page.getByRole('button', { name: 'bonds: automatic range, no threshold' }).click();
    await page.locator('.scene-caption').filter({ hasNotText: 'to 0.5' }).waitFor();
    same(await picture(page), first);
  });

  test('a threshold hides exactly the bonds outside of it', async () => {
    const { normal_force } = await columns('press/bonds.csv');
    const below = normal_force.filter((force) => force < -1).length;
    const least = page.getByLabel('bonds: hide below');
    await least.fill('-1');
    await least.press('Enter');
    await says(page, `${below.toLocaleString('en')} bonds hidden by the threshold.`);
    assert.ok((await seen(page, await picture(page))).blue < (await seen(page, first)).blue);
    await page.getByRole('button', { name: 'bonds: automatic range, no threshold' }).click();
    await page.locator('.scene-caption').filter({ hasNotText: 'threshold' }).waitFor();
  });

  test('powers of ten are offered for what has no sign', async () => {
    const choose = page.getByLabel('Colour of bonds');
    const byTens = page.locator('.scene-controls').getByLabel('by powers of ten').first();
    assert.equal(await byTens.isVisible(), false);
    await choose.selectOption(await choose.locator('option', { hasText: /^energy/ }).getAttribute('value'));
    await says(page, /Bonds: energy[^.]* from 0 /);
    const linear = await picture(page);
    await byTens.check();
    await says(page, /Bonds: energy.* by powers of ten from [1-9]/);
    different(await picture(page), linear);
    await byTens.uncheck();
    await choose.selectOption({
      label: await choose.locator('option', { hasText: /^normal_force/ }).textContent(),
    });
    await says(page, /Bonds: normal_force/);
    same(await picture(page), first);
  });

  test('displacements move the picture by the factor that is told', async () => {
    const { ux, uy, uz, x, y, z, radius } = await columns('press/particles.csv');
    const factor = Number(/Displacements x ([\d.e]+)\./.exec(await caption(page))[1]);
    const largest = Math.max(...ux.map((_, i) => Math.hypot(ux[i], uy[i], uz[i])));
    const side = (at) =>
      Math.max(...at.map((v, i) => v + radius[i])) - Math.min(...at.map((v, i) => v - radius[i]));
    const part = (largest * factor) / Math.hypot(side(x), side(y), side(z));
    assert.ok(part > 0.08 / 1.6 && part < 0.08 * 1.6, `${part} of the diagonal`);
    await page.getByRole('button', { name: 'Displacements not drawn' }).click();
    await says(page, 'Displacements not drawn');
    const unmoved = await picture(page);
    different(unmoved, first);
    const slider = page.getByLabel('Displacements', { exact: true });
    await slider.focus();
    await page.keyboard.press('End');
    await says(page, /Displacements x /);
    different(await picture(page), unmoved);
    await page.getByRole('button', { name: 'Displacements at the automatic scale' }).click();
    await says(page, `Displacements x ${factor}.`);
    same(await picture(page), first);
  });

  test('keys look from each side, and r comes home', async () => {
    const pictures = [];
    for (const key of ['x', 'Shift+X', 'y', 'Shift+Y', 'z', 'Shift+Z']) {
      await press(page, key);
      pictures.push((await picture(page)).toString('base64'));
    }
    assert.equal(new Set(pictures).size, 6);
    for (const [i, key] of ['1', '2', '3', '4', '5', '6'].entries()) {
      await press(page, key);
      assert.ok((await picture(page)).toString('base64') === pictures[i], `key ${key}`);
    }
    await press(page, 'x');
    await press(page, 'f');
    assert.ok((await picture(page)).toString('base64') === pictures[1], 'f is the other side');
    await press(page, 'r');
    same(await picture(page), first);
  });

  test('perspective looks otherwise from the same side', async () => {
    await page.getByLabel('perspective').check();
    await still(page);
    different(await picture(page), first);
    await page.getByLabel('perspective').uncheck();
    await press(page, 'r');
    same(await picture(page), first);
  });

  test('a click tells a bond as bonds.csv has it', async () => {
    const bonds = await columns('press/bonds.csv');
    const { id, said } = await pickA(page, 'Bond');
    const row = bonds.id.indexOf(id);
    assert.deepEqual(
      said['between particles'].split(' and ').map(Number).sort(),
      [bonds.a[row], bonds.b[row]].sort(),
    );
    const largest = Math.max(...bonds.fx.map(Math.abs));
    for (const name of ['normal_force', 'shear_force', 'sigma', 'tau', 'energy', 'bending_moment'])
      near(said[name], bonds[name][row], name);
    near(said['fx'], bonds.fx[row], 'fx', largest);
  });

  test('a click tells a particle as particles.csv has it, and Esc forgets it', async () => {
    const particles = await columns('press/particles.csv');
    const { id, said } = await pickA(page, 'Particle');
    const row = particles.id.indexOf(id);
    for (const name of ['x', 'y', 'z'])
      near(said[name], particles[name][row], name, Math.max(...particles.z));
    near(said['radius'], particles.radius[row], 'radius');
    for (const axis of ['x', 'y', 'z']) near(said[`displacement ${axis}`], particles[`u${axis}`][row], axis);
    await press(page, 'Escape');
    await page.locator('.scene-picked').waitFor({ state: 'hidden' });
    same(await picture(page), first);
  });

  test('a cut takes one side away, and flipped the other', async () => {
    await page.getByText('Cut', { exact: true }).click();
    await page.getByLabel('Across').selectOption('z');
    await still(page);
    const whole = (await seen(page, first)).marked;
    const low = await picture(page);
    await page.getByLabel('keep the other side').check();
    await still(page);
    const high = await picture(page);
    different(low, high);
    for (const half of [low, high]) {
      const part = (await seen(page, half)).marked / whole;
      assert.ok(part > 0.3 && part < 0.75, `${part} of the picture`);
    }
    await page.getByLabel('Across').selectOption('');
    same(await picture(page), first);
  });

  test('supports and particles can be hidden', async () => {
    await page.getByLabel('supports').uncheck();
    await still(page);
    const bare = await picture(page);
    different(bare, first);
    await page.getByLabel('particles', { exact: true }).uncheck();
    await still(page);
    assert.ok((await seen(page, await picture(page))).marked < (await seen(page, bare)).marked);
    await page.getByLabel('particles', { exact: true }).check();
    await page.getByLabel('supports').check();
    await still(page);
    same(await picture(page), first);
  });

  test('the picture is saved at twice the resolution, with its legend', async () => {
    const size = await canvas(page).boundingBox();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save the picture as PNG' }).click(),
    ]);
    assert.match(download.suggestedFilename(), /^yade-packing.*\.png$/);
    const png = await readFile(await download.path());
    assert.deepEqual(pngSize(png), {
      width: Math.round(size.width) * 2,
      height: Math.round(size.height) * 2,
    });
    const found = await seen(page, png);
    assert.ok(found.marked > 0.95 * (await seen(page, first)).marked, `${found.marked} pixels drawn`);
    same(await picture(page), first);
  });

  test('on paper stands the picture, without controls', async () => {
    await page.emulateMedia({ media: 'print' });
    await page.locator('.scene-paper').waitFor();
    const found = await seen(page, await page.locator('.scene-paper').screenshot());
    assert.ok(found.colours > 500);
    assert.equal(await page.locator('.scene-controls').isVisible(), false);
    await page.emulateMedia({ media: 'screen' });
    await page.locator('.scene-paper').waitFor({ state: 'hidden' });
  });

  test('a lost picture comes back', async () => {
    await still(page);
    await page.evaluate(() => {
      const gl = document.querySelector('.scene-canvas').getContext('webgl2');
      window.lost = gl.getExtension('WEBGL_lose_context');
      window.lost.loseContext();
    });
    await page.locator('.scene-message').filter({ hasText: 'took the picture back' }).waitFor();
    await page.evaluate(() => window.lost.restoreContext());
    await page.locator('.scene-message').waitFor({ state: 'hidden' });
    await still(page);
    same(await picture(page), first);
    // three tells the console that it lost the context and has it again.
    problems.splice(
      0,
      problems.length,
      ...problems.filter((problem) => !/Context (Lost|Restored)|CONTEXT_LOST/.test(problem)),
    );
  });
});
