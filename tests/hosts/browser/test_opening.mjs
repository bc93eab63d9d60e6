// Opening meshes; no data leave the page.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import {
  appendFileSync, copyFileSync, cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { mesh } from './meshes.mjs';
import { openPage, servePage } from './page.mjs';
import { around } from './places.mjs';

async function drawTwo(page) {
  for (const at of (await around(page, 25)).slice(0, 2)) await page.click(...at);
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 2 points']);
  await page.key('Enter');
  assert.ok((await page.reported('length')) > 0);
}

/** A new user only presses the button of the sample. */
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

/** The content policy blocks every request by a script. */
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

/** Reading 638,000 faces takes a while. The earlier mesh stays, with its drawing. */
export async function longOpeningCanBeEnded() {
  const page = await openPage();
  await page.openMesh(mesh('ball'));
  await drawTwo(page);
  const length = await page.reported('length');
  const [chooser] = await Promise.all([page.page.waitForFileChooser(),
    page.page.click('#panel [data-act="choose-mesh"]')]);
  await chooser.accept([mesh('large')]);
  // The button is pressed as soon as it appears, since the work after reading is quick.
  await page.page.waitForFunction(() => {
    const busy = document.getElementById('busy');
    if (!busy.hidden) busy.querySelector('button').click();
    return !busy.hidden;
  });
  await page.page.waitForFunction(() => document.getElementById('told').textContent === 'Ended.');
  await page.rest();
  assert.equal(await page.text('mesh-name'), 'ball.off');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
  assert.equal(await page.reported('length'), length);
  // It can be drawn on.
  const [x, y] = (await around(page, 25))[2];
  await page.click(x, y);
  assert.equal((await page.curves()).length, 2);
}

/** Sizes and defects of the mesh are computed only on request, since it takes longer than opening. */
export async function allAboutTheMesh() {
  const page = await openPage();
  await page.openMesh(mesh('twice'));
  assert.equal(await page.text('mesh-text'), '');
  await page.page.click('#mesh-all summary');
  await page.page.waitForFunction(() => document.getElementById('mesh-text').textContent.includes('repeats another face'));
  await page.openMesh(mesh('ball'));
  await page.page.waitForFunction(() => document.getElementById('mesh-text').textContent.includes('none (closed)'));
}

/** Without the server the page continues, can be reloaded, and works. */
export async function withoutANet() {
  const { url, unplug } = await servePage();
  const page = await openPage({ url });
  await page.page.waitForFunction(() => document.getElementById('offline-told').checkVisibility());
  await unplug();
  await page.openMesh(mesh('ball'));
  await drawTwo(page);
  await page.page.waitForFunction(() => sessionStorage.getItem('talweg.mesh')
    && sessionStorage.getItem('talweg.session').includes('"unfinished\\":false'));
  await page.load();
  await page.page.waitForFunction(() => document.querySelector('#curve-list li'));
  await page.rest();
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
  await page.act('sample');
  await page.page.waitForFunction(() => document.getElementById('told').textContent.includes('stone.ply'));
  await page.rest();
  await drawTwo(page);
}

/** A version that arrives during a visit starts with the next visit, and the old version's files
   are removed. */
export async function aNewerVersion() {
  const folder = mkdtempSync(join(tmpdir(), 'talweg-versions-'));
  cpSync(process.env.TALWEG_PAGE, folder, { recursive: true });
  const { url, unplug } = await servePage(folder);
  const page = await openPage({ url });
  await page.page.waitForFunction(() => document.getElementById('offline-told').checkVisibility());
  const kept = () => page.page.evaluate(async () => {
    const style = await (await fetch('style.css')).text();
    return { versions: (await caches.keys()).length, isNew: style.includes('/* new */') };
  });
  assert.deepEqual(await kept(), { versions: 1, isNew: false });

  // The service worker that build.mjs would make.
  const [style, worker] = ['style.css', 'service_worker.js'].map((name) => join(folder, name));
  const hash = () => createHash('sha256').update(readFileSync(style)).digest('base64');
  const before = hash();
  appendFileSync(style, '/* new */');
  const text = readFileSync(worker, 'utf8').replace(before, hash()).replace(/"[0-9a-f]{16}"/, '"0123456789abcdef"');
  writeFileSync(worker, text);
  await page.load();
  await page.page.waitForFunction(async () => (await navigator.serviceWorker.getRegistration()).waiting !== null);
  assert.equal((await kept()).isNew, false);
  await Promise.all([page.page.waitForNavigation(), page.page.reload()]);
  await page.page.waitForFunction(async () => (await caches.keys()).length === 1
    && (await (await fetch('style.css')).text()).includes('/* new */'));
  await unplug();
  await page.load();
  assert.deepEqual(await kept(), { versions: 1, isNew: true });
}

/** A browser without a service worker loads everything at the start. */
export async function theNetGoesWithoutAServiceWorker() {
  const { url, unplug } = await servePage();
  const page = await openPage({ url, script: 'delete Navigator.prototype.serviceWorker' });
  await unplug();
  for (const kind of ['twice', 'ball']) await page.openMesh(mesh(kind));
  await drawTwo(page);
  assert.equal(await page.text('trouble-mesh'), '');
}

/** Drops files as the system's file manager does. */
async function dropPaths(page, ...files) {
  const client = await page.page.createCDPSession();
  const { x, y } = await page.middle();
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop']) {
    await client.send('Input.dispatchDragEvent', { type, x, y, data });
  }
}

export async function foldersAndSeveralMeshes() {
  const folder = mkdtempSync(join(tmpdir(), 'talweg-dropped-'));
  const [empty, one, deep] = ['empty', 'one', 'one/deep'].map((name) => join(folder, name));
  for (const path of [empty, one, deep]) mkdirSync(path);
  writeFileSync(join(empty, 'notes.pdf'), 'nothing');
  const page = await openPage();
  await dropPaths(page, empty);
  await page.page.waitForFunction(() => document.getElementById('alarm').textContent.length > 0);
  assert.match(await page.text('trouble-mesh'), /^There is no mesh in empty: this page opens OBJ, /);

  copyFileSync(mesh('ball'), join(deep, 'ball.off'));
  writeFileSync(join(one, 'notes.pdf'), 'nothing');
  await dropPaths(page, one);
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent === 'ball.off');
  await page.rest();
  assert.equal(await page.text('alarm'), '');
  assert.equal(await page.page.title(), 'ball.off – Talweg');

  await dropPaths(page, mesh('ball'), mesh('twice'));
  await page.page.waitForSelector('#choice[open]');
  await page.picture('choice');
  assert.deepEqual(await page.page.$$eval('#choice-list button', (all) => all.map((b) => b.textContent)),
    ['ball.off', 'twice.off']);
  await page.page.click('#choice-list li:last-child button');
  await page.page.waitForFunction(() => document.getElementById('mesh-name').textContent === 'twice.off');
  await page.rest();
}

export async function withoutWebGL() {
  const page = await openPage({ ready: '#trouble-mesh:not(:empty)',
    script: 'HTMLCanvasElement.prototype.getContext = () => null' });
  assert.match(await page.text('trouble-mesh'), /^The page cannot work here: this browser has no WebGL 2/);
  assert.equal(await page.text('alarm'), await page.text('trouble-mesh'));
  await page.picture('no-webgl');
}

/** Errors are shown on the mesh, and disappear with the next action. */
export async function aTroubleIsOver() {
  const page = await openPage();
  await page.choose('choose-mesh', mesh('broken'));
  await page.page.waitForFunction(() => document.getElementById('alarm').textContent.includes('broken.off'));
  await page.openMesh(mesh('ball'));
  assert.equal(await page.text('alarm'), '');
  await page.choose('choose-mesh', mesh('broken'));
  await page.page.waitForFunction(() => document.getElementById('alarm').textContent.includes('broken.off'));
  await page.rest();
  assert.equal(await page.text('mesh-name'), 'ball.off');
  await drawTwo(page);
  for (const id of ['alarm', 'trouble-mesh']) assert.equal(await page.text(id), '');
}
