// Drawing and editing without a mouse.
import assert from 'node:assert/strict';
import { mesh } from './meshes.mjs';
import { openPage } from './page.mjs';

/** Presses Tab until an element has the focus. */
async function tabTo(page, selector) {
  for (let k = 0; k < 60; ++k) {
    if (await page.page.evaluate((s) => document.activeElement?.matches(s), selector)) return;
    await page.page.keyboard.press('Tab');
  }
  throw new Error(`Tab does not reach ${selector}.`);
}

async function press(page, key, times) {
  for (let k = 0; k < times; ++k) await page.page.keyboard.press(key);
}

async function withMesh() {
  const page = await openPage();
  await page.openMesh(mesh('ball'));
  await page.page.evaluate(() => document.activeElement?.blur());
  await tabTo(page, '#view');
  return page;
}

export async function aClosedCurve() {
  const page = await withMesh();
  await page.key('Space');
  for (const way of ['ArrowRight', 'ArrowDown', 'ArrowLeft']) {
    await press(page, way, 5);
    await page.key('Space');
  }
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 4 points']);
  await page.picture('keys');
  await press(page, 'ArrowUp', 5);
  await page.key('Space');
  assert.deepEqual(await page.curves(), ['Curve 1 closed, 4 points']);
}

export async function carryPinAndRemove() {
  const page = await withMesh();
  for (let k = 0; k < 3; ++k) {
    await page.key('Space');
    await press(page, 'ArrowRight', 4);
  }
  await page.key('Enter');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  const before = await page.reported('length');
  await page.key('n', 'n', 'm');
  await press(page, 'ArrowUp', 3);
  await page.key('m');
  assert.ok((await page.reported('length')) > before);
  await page.key('p');
  assert.equal(await page.page.$eval('[data-act="pin"]', (e) => e.getAttribute('aria-pressed')), 'true');
  await page.key('Delete');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
  await page.page.keyboard.down('Control');
  await page.key('z', 'z', 'z');
  await page.page.keyboard.up('Control');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  assert.equal(await page.reported('length'), before);
}

export async function aPointIsInsertedIntoTheCurve() {
  const page = await withMesh();
  await page.key('Space');
  await press(page, 'ArrowRight', 8);
  await page.key('Space', 'Enter');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
  // Moves back along the nearly straight curve, and up and down in small steps, until the hint says
  // that the curve is met.
  await press(page, 'ArrowLeft', 4);
  const meets = async () => (await page.text('hint')).includes('on the curve');
  await page.page.keyboard.down('Shift');
  for (let k = 0; k < 12 && !(await meets()); ++k) await page.key('ArrowUp');
  for (let k = 0; k < 24 && !(await meets()); ++k) await page.key('ArrowDown');
  await page.page.keyboard.up('Shift');
  await page.key('Space');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
}

export async function everyControlIsReached() {
  const page = await withMesh();
  const reached = new Set();
  for (let k = 0; k < 90; ++k) {
    await page.page.keyboard.press('Tab');
    const id = await page.page.evaluate(() => {
      const e = document.activeElement;
      return e?.id || e?.dataset?.act || e?.textContent;
    });
    reached.add(id);
  }
  const all = await page.page.evaluate(() =>
    [...document.querySelectorAll('#panel button, #panel input, #panel select')]
      .filter((e) => !e.disabled && e.checkVisibility()).map((e) => e.id || e.dataset.act || e.textContent));
  assert.deepEqual(all.filter((id) => !reached.has(id)), []);
}

export async function theHelpListsTheKeys() {
  const page = await withMesh();
  await page.page.keyboard.type('?');
  assert.ok(await page.page.$eval('#help', (dialog) => dialog.open));
  await page.picture('help');
  await page.key('Escape');
  assert.ok(!(await page.page.$eval('#help', (dialog) => dialog.open)));
}

/** After the sample is opened by keys, keys act on the mesh, and Ctrl+Z in a box acts on its
   text. */
export async function fromTheSampleToTheMesh() {
  const page = await openPage();
  await tabTo(page, '#start [data-act="sample"]');
  await page.key('Enter');
  await page.page.waitForFunction(() => document.getElementById('told').textContent.includes('Draw on it'));
  await page.rest();
  assert.equal(await page.page.evaluate(() => document.activeElement.id), 'view');
  await page.key('Space');
  await press(page, 'ArrowRight', 5);
  await page.key('Space', 'Enter');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
  await tabTo(page, '#tau-number');
  await page.page.keyboard.type('37');
  const tau = () => page.page.$eval('#tau-number', (box) => box.value);
  assert.match(await tau(), /37/);
  await page.page.keyboard.down('Control');
  await page.key('z');
  await page.page.keyboard.up('Control');
  assert.doesNotMatch(await tau(), /37/);
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
}
