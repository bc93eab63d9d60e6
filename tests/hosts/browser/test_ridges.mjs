// A stroke beside a crease whose place is known is moved onto it, as strongly as the slider says.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { curvesIn, farthest, talweg } from './driver.mjs';
import { mesh, sheetVertex } from './meshes.mjs';
import { openPage } from './page.mjs';

/** A stroke over vertices of the roof: along y = 13, which is two edges beside its crease, or on it. */
async function withStroke(y, size = {}) {
  const page = await openPage(size);
  await page.openMesh(mesh('roof'));
  const points = [];
  for (let x = 4; x <= 26; ++x) points.push(sheetVertex(x, y));
  const file = join(page.downloads, 'saved-stroke.json');
  writeFileSync(file, JSON.stringify({ format: 'talweg-curves', version: 1, curves: [{ closed: false, points }] }));
  await page.choose('choose-curves', file);
  await page.page.waitForFunction(() => document.querySelector('#reports table'));
  await page.rest();
  return page;
}

async function snap(page, strength) {
  await page.page.$eval('#ridges-number', (box, value) => {
    box.value = value;
    box.dispatchEvent(new Event('change'));
  }, String(strength));
  await page.rest();
}

const kindIsOff = (page) => page.page.$eval('#ridge-kind', (box) => box.disabled);

/** How far from the crease the middle of the saved curve lies. */
async function apart(page) {
  const [curve] = curvesIn(await page.saved(() => page.act('save-curves')));
  const places = curve.points.map(({ xyz }) => xyz).filter(([x]) => x > 10 && x < 20);
  return Math.max(...places.map(([, y]) => Math.abs(y - 15)));
}

export async function aStrokeIsMovedOntoTheCrease() {
  const page = await withStroke(13, { width: 1280, height: 800 });
  assert.equal(await page.text('ridges-told'), '');
  assert.equal(await page.row('ridges'), '');
  assert.equal(await kindIsOff(page), true);
  assert.ok(Math.abs((await apart(page)) - 2) < 0.5);
  await snap(page, 1);
  assert.ok((await apart(page)) < 0.2);
  assert.match(await page.row('ridges'), /^\d+ % of the drawing moved onto them, by up to 2\.\d+$/);
  assert.equal(await page.text('ridges-told'), `Ridges: ${await page.row('ridges')}.`);
  assert.equal(await kindIsOff(page), false);
  await page.page.$eval('#ridges', (box) => box.scrollIntoView({ block: 'center' }));
  await page.picture('ridges');

  await page.page.select('#ridge-kind', 'concave');
  await page.rest();
  assert.match(await page.row('ridges'), /^none that is strong enough within [\d.]+ of the drawing$/);
  assert.ok(Math.abs((await apart(page)) - 2) < 0.5);
  await page.page.evaluate(() => (document.getElementById('command-details').open = true));
  await page.page.waitForFunction(() => /--ridges 1 --ridge-kind concave /.test(document.getElementById('command').textContent));
  await page.act('undo');
  assert.ok((await apart(page)) < 0.2);
  await page.act('undo');
  assert.equal(await page.page.$eval('#ridges-number', (box) => box.value), '0');
  assert.equal(await page.row('ridges'), '');

  // A bad strength is refused, and the field shows the unchanged value.
  await snap(page, 2);
  assert.equal(await page.text('trouble-drawing'), 'The strength of ridges must be from 0 to 1.');
  assert.equal(await page.page.$eval('#ridges-number', (box) => box.value), '0');
}

export async function theSameAsTheDriver() {
  const page = await withStroke(13);
  await snap(page, 0.8);
  const ours = await page.saved(() => page.act('save-curves'));
  await page.page.select('#curve-format', 'drawn.json');
  const drawn = await page.saved(() => page.act('save-curves')), theirs = join(page.downloads, 'saved-driver.json');
  talweg('smooth', mesh('roof'), '--curve', drawn, '--ridges', '0.8', '--border', 'snap', '-o', theirs);
  assert.ok(farthest(curvesIn(ours), curvesIn(theirs)) < 1e-9);
  // The strength is stored with the drawing.
  await page.load();
  await page.page.waitForFunction(() => document.querySelector('#reports table'));
  await page.rest();
  assert.equal(await page.page.$eval('#ridges-number', (box) => box.value), '0.8');
  assert.match(await page.row('ridges'), /moved onto them/);
}

/** In a narrow window, where the text is longer than the panel is wide. */
export async function onTheCreaseAlready() {
  const page = await withStroke(15, { width: 360, height: 640 });
  await snap(page, 1);
  assert.equal(await page.row('ridges'), '100 % of the drawing lies on them already; nothing had to be moved');
  assert.ok((await apart(page)) < 0.2);
  await page.page.$eval('#ridges', (box) => box.scrollIntoView({ block: 'center' }));
  await page.picture('ridges-narrow');
  assert.ok(await page.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
}
