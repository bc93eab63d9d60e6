// Axe checks the page in its states, light and dark.
import assert from 'node:assert/strict';
import { mesh } from './meshes.mjs';
import { axeSource, openPage } from './page.mjs';
import { around, withMesh } from './places.mjs';

async function look(page, where) {
  // The test's script bypasses the page's content policy, as the browser's tools do.
  const { violations } = await page.page.evaluate(async (source) => {
    new Function(source)();
    return globalThis.axe.run(document, { resultTypes: ['violations'] });
  }, axeSource()).catch(async () => {
    await page.page.evaluate(axeSource());
    return page.page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
  });
  const told = violations.map(({ id, help, nodes }) => `${where}: ${id}: ${help}: ${nodes.map((n) => n.html).join('; ')}`);
  assert.deepEqual(told, []);
}

async function everyState(options, name) {
  const page = await openPage(options);
  await look(page, `${name}, start`);
  await page.picture(`${name}-start`);
  await page.openMesh(mesh('ball'));
  const [a, b, c, d] = await around(page, 40);
  await page.drag([a, b, c, d, a]);
  await page.click(...a);
  await page.page.select('#colour', 'deviation');
  await page.page.evaluate(() => document.querySelectorAll('details').forEach((e) => (e.open = true)));
  await page.rest();
  await look(page, `${name}, drawn`);
  await page.picture(`${name}-drawn`);
  await page.act('cut');
  await page.page.waitForSelector('#part-list li');
  await page.rest();
  await look(page, `${name}, cut`);
  await page.act('help');
  await look(page, `${name}, help`);
}

export const light = () => everyState({}, 'light');
export const dark = () => everyState({ dark: true }, 'dark');

/** A window of 1280 pixels at 200 %. */
export const large = () => everyState({ width: 640, height: 400 }, 'large');

export async function aBadFileIsToldBesideTheMesh() {
  const page = await withMesh();
  await page.choose('choose-mesh', mesh('broken'));
  await page.page.waitForFunction(() => document.getElementById('trouble-mesh').textContent.length > 0);
  await page.rest();
  assert.match(await page.text('trouble-mesh'), /broken\.off/);
  await look(page, 'a bad file');
  // The earlier mesh can still be drawn on.
  const [a, b] = await around(page);
  await page.click(...a);
  await page.click(...b);
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 2 points']);
}

export async function repairIsOffered() {
  const page = await openPage();
  await page.openMesh(mesh('twice'));
  const [a] = await around(page, 20);
  await page.click(...a);
  await page.page.focus('#view');
  await page.key('ArrowRight', 'Space');
  assert.deepEqual(await page.curves(), []);
  await page.picture('repair');
  await look(page, 'repair');
  // The ball has 224 faces, and one of them comes twice.
  assert.match(await page.text('repair-list'), /^1 face that repeats another would be dropped/);
  await page.act('repair');
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent.includes('repaired'));
  await page.rest();
  assert.match(await page.text('repair-why'), /^Repaired: 224 faces and 114 vertices/);
  assert.match(await page.text('repair-list'), /^1 face that repeats another was dropped/);
  await page.click(...a);
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 1 point']);
}

/** A curve cannot leave a triangle of the soup until they are welded, here within 1e-7. */
export async function aSoupIsWelded() {
  const page = await openPage();
  for (const kind of ['soup', 'loose']) {
    await page.openMesh(mesh(kind));
    assert.match(await page.text('hint'), /“Repair” welds them/);
    assert.match(await page.text('repair-list'), /would be welded: 224 parts would become 1, 224 borders would become 0/);
    await page.picture(kind);
    await page.act('repair');
    await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent.includes('repaired'));
    await page.rest();
    assert.match(await page.text('repair-why'), /^Repaired: 224 faces and 114 vertices/);
    assert.match(await page.text('mesh-facts'), /^faces224vertices114size/);
    for (const at of (await around(page, 40)).slice(0, 3)) await page.click(...at);
    await page.key('Enter');
    assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
    assert.ok((await page.reported('length')) > 0);
  }
  // A tolerance below the gaps welds nothing.
  await page.page.$eval('#weld', (box) => (box.value = '1e-9'));
  await page.act('repair');
  assert.match(await page.text('repair-why'), /^Repaired: 224 faces and 672 vertices/);
  await page.page.$eval('#weld', (box) => (box.value = ''));
  await page.act('repair');
  assert.match(await page.text('repair-why'), /^Repaired: 224 faces and 114 vertices/);
  await page.page.evaluate(() => (document.getElementById('command-details').open = true));
  await page.page.waitForFunction(() => /--repair=weld=[\d.e-]+,drop,orient,split/.test(
    document.getElementById('command').textContent));
}
