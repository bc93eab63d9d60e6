// Sessions are not lost, and not stored on the machine without consent.
import assert from 'node:assert/strict';
import { mesh } from './meshes.mjs';
import { openPage } from './page.mjs';
import { around, withMesh } from './places.mjs';

/** A newly drawn curve, on a mesh that is stored. */
async function drawn(options) {
  const page = await withMesh(options);
  await page.page.waitForFunction(() => document.getElementById('kept-told').textContent.includes('kept'));
  for (const at of (await around(page)).slice(0, 3)) await page.click(...at);
  await page.key('Enter');
  return page;
}

async function again(page) {
  await page.load();
  await page.page.waitForFunction(() => document.querySelector('#curve-list li'));
  await page.rest();
}

function onMachine(page) {
  return page.page.evaluate(async () => ({
    local: localStorage.length, databases: (await indexedDB.databases()).map((one) => one.name),
  }));
}

export async function thisTabKeepsIt() {
  const page = await drawn();
  const length = await page.reported('length');
  await again(page);
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  assert.equal(await page.reported('length'), length);
  assert.deepEqual(await onMachine(page), { local: 0, databases: [] });
}

/** A browser that leaves a page does not wait for unfinished work. */
export async function leavingKeepsAtOnce() {
  const page = await drawn();
  const drawings = await page.page.evaluate(() => {
    sessionStorage.removeItem('talweg.session');
    Object.defineProperty(document, 'visibilityState', { value: 'hidden' });
    dispatchEvent(new Event('visibilitychange'));
    return Object.keys(sessionStorage).filter((key) => key === 'talweg.session');
  });
  assert.deepEqual(drawings, ['talweg.session']);
}

export async function theMachineKeepsItWhenAsked() {
  const page = await drawn();
  await page.page.click('#on-machine');
  await page.page.waitForFunction(() => document.getElementById('kept-told').textContent.includes('on this device'));
  assert.deepEqual((await onMachine(page)).databases, ['talweg']);
  await page.page.evaluate(() => sessionStorage.clear());
  await again(page);
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);

  // The page asks; Escape and the first answer keep everything.
  await page.act('forget');
  await page.picture('forget');
  await page.key('Escape');
  assert.equal(await page.page.evaluate(() => document.activeElement.dataset.act), 'forget');
  await page.key('Enter', 'Enter');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  await page.act('forget');
  await Promise.all([page.page.waitForNavigation(), page.page.click('[data-act="forget-now"]')]);
  await page.page.waitForSelector('html[data-ready]');
  assert.deepEqual(await page.curves(), []);
  assert.deepEqual(await onMachine(page), { local: 0, databases: [] });
  assert.equal(await page.page.evaluate(() => sessionStorage.length), 0);
}

export async function whatIsBeingKeptIsForgottenToo() {
  const page = await drawn();
  await page.page.click('#on-machine');
  await page.page.waitForFunction(() => document.getElementById('kept-told').textContent.includes('on this device'));
  await Promise.all([page.page.waitForNavigation(), page.page.evaluate(() => {
    Object.defineProperty(document, 'visibilityState', { value: 'hidden' });
    dispatchEvent(new Event('visibilitychange'));  // stores at once
    document.querySelector('[data-act="forget-now"]').click();
  })]);
  await page.page.waitForSelector('html[data-ready]');
  assert.deepEqual(await page.curves(), []);
  assert.deepEqual(await onMachine(page), { local: 0, databases: [] });
  assert.equal(await page.page.evaluate(() => sessionStorage.length), 0);
}

export async function aSessionFileOpensAgain() {
  const page = await drawn();
  const length = await page.reported('length');
  const file = await page.saved(() => page.act('save-session'));
  assert.match(file, /ball\.talweg$/);
  const other = await openPage();
  await other.choose('choose-session', file);
  await other.page.waitForFunction(() => document.querySelector('#curve-list li'));
  await other.rest();
  assert.deepEqual(await other.curves(), ['Curve 1 open, 3 points']);
  assert.equal(await other.reported('length'), length);
}

async function sampleOpened(page) {
  await page.act('sample');
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent === 'stone.ply');
  await page.rest();
}

function asides(page) {
  return page.page.$$eval('#asides li', (all) => all.map((one) => one.textContent.trim()));
}
const ballAside = 'The drawing on ball.off (1 curve) was put aside. Bring it back';

/** Undo reverts the opening, and then the steps of the earlier drawing. */
export async function anotherMeshTakesNoDrawing() {
  const page = await drawn();
  const length = await page.reported('length');
  await sampleOpened(page);
  assert.deepEqual(await page.curves(), []);
  assert.deepEqual(await asides(page), [ballAside]);
  await page.picture('put-aside');

  await page.act('undo');
  assert.equal(await page.text('mesh-name'), 'ball.off');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  assert.equal(await page.reported('length'), length);
  assert.deepEqual(await asides(page), []);
  await page.act('redo');
  assert.equal(await page.text('mesh-name'), 'stone.ply');
  assert.deepEqual(await asides(page), [ballAside]);
  await page.act('undo');
  await page.act('undo');
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 3 points']);
}

export async function whatWasPutAsideIsThereAfterAReload() {
  const page = await drawn();
  const length = await page.reported('length');
  await sampleOpened(page);
  await page.page.waitForFunction(() => sessionStorage.getItem('talweg.session').includes('stone.ply')
    && JSON.parse(sessionStorage.getItem('talweg.asides'))[0].mesh.bytes.length > 0);
  await page.load();
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent === 'stone.ply');
  assert.deepEqual(await asides(page), [ballAside]);
  // Nothing is drawn on the new mesh yet, so Undo brings the earlier one back.
  await page.act('undo');
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent === 'ball.off');
  await page.act('redo');
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent === 'stone.ply');
  await page.rest();
  const [a, b] = await around(page, 25);
  await page.click(...a);
  await page.click(...b);
  await page.page.click('#asides button');
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent === 'ball.off');
  await page.rest();
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  assert.equal(await page.reported('length'), length);
  assert.deepEqual(await asides(page), ['The drawing on stone.ply (1 curve) was put aside. Bring it back']);
  assert.equal(await page.page.evaluate(() => document.activeElement.id), 'view');
}

/** A mesh that the tab has no room for: the drawing waits until the user opens the mesh. */
export async function aDrawingWaitsForItsMesh() {
  const page = await drawn();
  await page.page.waitForFunction(() => JSON.parse(sessionStorage.getItem('talweg.session')).drawing.includes('face'));
  await page.page.evaluate(() => sessionStorage.removeItem('talweg.mesh'));
  await page.load();
  assert.match((await asides(page))[0], /The drawing on ball\.off \(1 curve\) waits for its mesh.*open ball\.off again/);
  await sampleOpened(page);
  assert.equal((await asides(page)).length, 1);
  await page.openMesh(mesh('ball'));
  await page.page.waitForFunction(() => document.querySelector('#curve-list li'));
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  assert.deepEqual(await asides(page), []);
}

/** The second tab says so, overwrites nothing, and puts the first tab's session aside when that tab
   is closed. */
export async function twoTabsDoNotWriteOverEachOther() {
  const first = await drawn();
  await first.page.click('#on-machine');
  await first.page.waitForFunction(() => document.getElementById('kept-told').textContent.includes('on this device'));
  const second = await openPage({ context: first.context });
  assert.ok(await second.page.$eval('#other-tab', (told) => told.checkVisibility()));
  assert.deepEqual(await second.curves(), []);
  await sampleOpened(second);
  await second.page.waitForFunction(() => document.getElementById('kept-told').textContent.includes('tab'));
  await first.page.close();
  await second.page.waitForFunction(() => document.querySelector('#asides li'));
  assert.deepEqual(await asides(second), [ballAside]);
  assert.ok(!(await second.page.$eval('#other-tab', (told) => told.checkVisibility())));
}
