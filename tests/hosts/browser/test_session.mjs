// Nothing is lost, and nothing is kept on the machine unasked.
import assert from 'node:assert/strict';
import { openPage } from './page.mjs';
import { around, withMesh } from './places.mjs';

/** A curve that was drawn a moment ago, on a mesh that is kept. */
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

/** A browser that leaves a page waits for nothing that is still to come. */
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

  await Promise.all([page.page.waitForNavigation(), page.page.click('[data-act="forget"]')]);
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
    dispatchEvent(new Event('visibilitychange'));  // keeps at once
    document.querySelector('[data-act="forget"]').click();
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
