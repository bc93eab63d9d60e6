// Decisive warnings are visible at once: beside the curve, on the mesh, and below it.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { mesh, sheetVertex as vertex } from './meshes.mjs';
import { openPage } from './page.mjs';
import { around, withMesh } from './places.mjs';

/** A file with a drawing along the grid from corner to corner, a point at every vertex. */
function along(page, corners, clicked) {
  let [x, y] = corners[0];
  const points = [vertex(x, y)], ends = [0];
  for (const [toX, toY] of corners.slice(1)) {
    while (x !== toX || y !== toY) {
      x += Math.sign(toX - x);
      y += Math.sign(toY - y);
      points.push(vertex(x, y));
    }
    ends.push(points.length - 1);
  }
  if (clicked) {
    for (const k of ends) points[k].exact = true;
    points.at(-2).exact = false;
  } else {
    for (const point of points) point.exact = false;
  }
  const path = join(page.downloads, 'saved-drawn.json');
  writeFileSync(path, JSON.stringify({ format: 'talweg-curves', version: 1, curves: [{ closed: false, points }] }));
  return path;
}

/** The curve of such a drawing on the sheet: painted, or clicked at its corners with a stroke at
   its end. */
async function drawn(corners, clicked = false) {
  const page = await openPage();
  await page.openMesh(mesh('sheet'));
  await page.choose('choose-curves', along(page, corners, clicked));
  await page.page.waitForFunction(() => document.querySelector('#reports table'));
  await page.rest();
  return page;
}

async function set(page, id, value) {
  await page.page.$eval(`#${id}`, (box, text) => {
    box.value = text;
    box.dispatchEvent(new Event('change'));
  }, String(value));
  await page.rest();
}

const badges = (page) => page.page.$$eval('#curve-list .badge', (all) => all.map((badge) => badge.textContent));
const rings = (page) => page.page.$$eval('.mark.alarm', (all) => all.map((mark) => mark.textContent));
const alert = async (page) =>
  (await page.page.$eval('#alert', (line) => line.hidden)) ? '' : page.text('alert-text');

/** The arms are 15 long and 3 apart, so the line between the ends leaves 15 of the drawing out. */
export async function aUThatCollapses() {
  const page = await drawn([[5, 4], [5, 19], [8, 19], [8, 4]]);
  assert.deepEqual(await rings(page), []);
  assert.equal(await alert(page), '');
  await set(page, 'tau-number', 0.001);
  assert.equal(await page.row('farthest apart'), '≥ 15');
  assert.equal(await page.row('which is'), 'the drawing from the curve');
  assert.match((await badges(page))[0], /^The result cuts off parts of the drawing/);
  assert.deepEqual(await rings(page), ['≥ 15']);
  assert.match(await alert(page), /^The result cuts off parts of the drawing/);
  await page.act('go-alert');
  // The part that was cut off has the colour of its distance.
  await page.page.select('#colour', 'deviation');
  await page.rest();
  assert.equal(await page.text('legend-to'), '15');
  await page.picture('collapsed-u');
  await page.act('undo');
  assert.deepEqual(await badges(page), []);
  assert.deepEqual(await rings(page), []);
  assert.equal(await alert(page), '');
}

/** The drawing goes from the click at (20, 10) back to the click at (14, 10), 6 away, and is
   painted from there. */
export async function aClickThatIsMissed() {
  const page = await drawn([[2, 10], [20, 10], [14, 10], [14, 20]], true);
  assert.match(await alert(page), /misses 1 of the points/);
  assert.equal(await page.row('farthest apart'), '≥ 6');
  assert.equal(await page.row('which is'), 'a point that the curve misses');
  assert.equal(await page.row('ended'), 'missed');
  assert.deepEqual(await rings(page), ['≥ 6']);
  await page.page.$eval('#panel', (panel) => panel.scrollTo(0, 0));
  await page.picture('missed-click');
}

/** The way back, 6 long, is left out of the result. */
export async function aBoundThatCannotBeHeld() {
  const page = await drawn([[2, 10], [20, 10], [14, 10], [14, 20]]);
  await page.page.click('#most-on');
  await page.rest();
  await set(page, 'most-number', 2);
  await page.picture('bound-fails');
  assert.match(await page.text('most-told'), /^Curve 1: no curve within the bound was found; .* 6 apart\.$/);
  assert.match((await badges(page))[0], /No curve within 2(\.0+)? of the drawing was found/);
  assert.equal((await rings(page)).length, 1);
  assert.match(await alert(page), /\(and 1 more: see “Curves”\)$/);
  await set(page, 'most-number', 8);
  assert.equal(await page.text('most-told'), '');
  assert.doesNotMatch((await badges(page))[0], /No curve within/);
}

/** The library counts curves from 0 and knows no unit. Both ends are 1 away from the border. */
export async function sentencesHaveThePagesWords() {
  const page = await drawn([[1, 10], [29, 10]]);
  await page.page.select('#mesh-unit', 'cm');
  await page.rest();
  await page.act('cut');
  assert.match(await page.text('notes'), /The start of Curve 1 lies 1(\.0+)? cm from the border/);
  await page.picture('words');
}

export async function aCurveThatSeparatesNothingHasItsName() {
  const page = await drawn([[10, 10], [20, 10]]);
  await page.act('cut');
  assert.match(await page.text('told'), /Curve 1 does not separate/);
  assert.doesNotMatch(await page.text('told'), /curve 0/i);
}

/** A leg from a stroke to a click is not a gap. */
export async function strokesAndClicks() {
  const page = await withMesh();
  const [a, b, c, d] = await around(page);
  await page.drag([a, b], { steps: 30 });
  for (const at of [c, d]) await page.click(...at);
  await page.key('Enter');
  assert.deepEqual(await badges(page), []);
  assert.equal(await alert(page), '');
}

export async function settingsWithoutEffectSayWhy() {
  const page = await withMesh();
  const [a, b, c, d] = await around(page);
  for (const at of [a, b]) await page.click(...at);
  await page.key('Enter');
  assert.match(await page.text('tau-told'), /two clicks are joined straight/);
  assert.match(await page.text('slack-told'), /for painted strokes/);
  await page.act('undo');
  await page.click(...c);
  await page.key('Enter');
  assert.equal(await page.text('tau-told'), '');
  await page.drag([d, [d[0] + 40, d[1] - 50]], { steps: 20 });
  await page.key('Enter');
  assert.equal(await page.text('slack-told'), '');
  await page.page.click('#most-on');
  await page.rest();
  assert.match(await page.text('tau-told'), /chooses τ/);
  assert.equal(await page.page.$eval('#tau', (slider) => slider.disabled), true);
}
