// How a mesh comes onto the page, and that nothing leaves it.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { mesh } from './meshes.mjs';
import { openPage } from './page.mjs';
import { around } from './places.mjs';

async function drawTwo(page) {
  for (const at of (await around(page, 25)).slice(0, 2)) await page.click(...at);
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 2 points']);
  await page.key('Enter');
  assert.ok((await page.reported('length')) > 0);
}

/** What a person does who reads nothing but the button. */
export async function theSample() {
  const page = await openPage();
  const began = Date.now();
  await page.act('sample');
  await page.page.waitForFunction(() => document.getElementById('told').textContent.includes('Draw on it'));
  await drawTwo(page);
  console.log(`  ${((Date.now() - began) / 1000).toFixed(1)} s from the button to the first curve`);
  await page.picture('sample');
}

export async function aPackedMesh() {
  const path = `${mesh('ball')}.gz`;
  writeFileSync(path, gzipSync(readFileSync(mesh('ball'))));
  const page = await openPage();
  await page.openMesh(path);
  await drawTwo(page);
}

export async function aDroppedMesh() {
  const page = await openPage();
  await page.page.evaluate((text) => {
    const files = new DataTransfer();
    files.items.add(new File([text], 'dropped.off'));
    const at = { bubbles: true, cancelable: true, dataTransfer: files };
    document.body.dispatchEvent(new DragEvent('dragover', at));
    document.body.dispatchEvent(new DragEvent('drop', at));
  }, readFileSync(mesh('ball'), 'utf8'));
  await page.page.waitForFunction(() => document.getElementById('told').textContent.includes('Draw on it'));
  await drawTwo(page);
}

/** The policy holds whatever a script would try. */
export async function noOtherHost() {
  const page = await openPage();
  const refused = await page.page.evaluate(async () => {
    const told = new Promise((done) => addEventListener('securitypolicyviolation',
      (event) => done(event.effectiveDirective), { once: true }));
    await fetch('https://talweg.invalid/').catch(() => {});
    return told;
  });
  assert.equal(refused, 'connect-src');
  const strangers = page.requests.filter((url) => !url.startsWith(page.url) && !url.includes('talweg.invalid'));
  assert.deepEqual(strangers, []);
  page.requests = [];
  page.errors = [];
}
