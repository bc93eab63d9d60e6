// Lengths with their unit, labels beside the curves, and offsets, whose lengths are known on a flat sheet.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { countIn, curvesIn, farthest, talweg } from './driver.mjs';
import { inMetres, inMillimetres, mesh, sheetVertex } from './meshes.mjs';
import { openPage } from './page.mjs';

/** Two clicks, 10 apart, on the sheet. */
async function withLine(path = mesh('sheet')) {
  const page = await openPage();
  await page.openMesh(path);
  const points = [sheetVertex(10, 15), sheetVertex(20, 15)].map((point) => ({ ...point, exact: true }));
  const file = join(page.downloads, 'saved-line.json');
  writeFileSync(file, JSON.stringify({ format: 'talweg-curves', version: 1, curves: [{ closed: false, points }] }));
  await page.choose('choose-curves', file);
  await page.page.waitForFunction(() => document.querySelector('#reports table'));
  await page.rest();
  return page;
}

async function choose(page, id, value) {
  await page.page.select(`#${id}`, value);
  await page.rest();
}

const labels = (page) => page.page.$$eval('.mark.length', (all) => all.filter((mark) => !mark.hidden).map((mark) => mark.textContent));
const offsets = (page) => page.page.$$eval('#offset-list li', (all) => all.map((item) => item.textContent));

async function write(page, id, number) {
  await page.page.$eval(`#${id}`, (box, value) => {
    box.value = value;
    box.dispatchEvent(new Event('change'));
  }, String(number));
  await page.rest();
}

async function withOffset(page, distance) {
  await page.page.click('#offset-on');
  await page.rest();
  await write(page, 'offset-number', distance);
}

export async function lengthsHaveTheUnitThatIsChosen() {
  const page = await withLine();
  assert.deepEqual(await labels(page), ['10']);
  assert.equal(await page.row('length'), '10 (drawn 10)');
  await choose(page, 'mesh-unit', 'cm');
  assert.deepEqual(await labels(page), ['10 cm']);
  assert.equal(await page.row('length'), '10 cm (drawn 10)');
  assert.match(await page.text('mesh-facts'), /size42\.43 cm/);
  await page.picture('lengths');
  await page.page.click('#show-lengths');
  await page.rest();
  assert.deepEqual(await labels(page), []);

  await page.page.evaluate(() => {
    navigator.clipboard.writeText = async (text) => (globalThis.copied = text);
  });
  await page.act('copy-table');
  const [head] = (await page.page.evaluate(() => globalThis.copied)).split('\r\n');
  assert.equal(head, 'curve,length [cm],x [cm],y [cm],z [cm],turning [1/cm],deviation [cm]');
  const report = JSON.parse(readFileSync(await page.saved(() => page.act('save-report')), 'utf8'));
  assert.equal(report.unit, 'cm');
  assert.equal(report.length_after, 10);
  await choose(page, 'curve-format', 'mrk.json');
  const markups = JSON.parse(readFileSync(await page.saved(() => page.act('save-curves')), 'utf8'));
  assert.equal(markups.markups[0].coordinateUnits, 'cm');

  await page.load();
  await page.page.waitForFunction(() => document.querySelector('#reports table'));
  await page.rest();
  assert.equal(await page.row('length'), '10 cm (drawn 10)');
  assert.deepEqual(await labels(page), []);
}

export async function theFileTellsItsUnit() {
  const page = await withLine(inMillimetres('sheet'));
  assert.deepEqual(await labels(page), ['10 mm']);
  assert.equal(await page.page.$eval('#mesh-unit', (box) => box.selectedOptions[0].textContent), 'mm, as its file says');
  assert.match(await page.text('slack-told'), /painted strokes/);
  const inGltf = await withLine(inMetres('sheet'));
  assert.deepEqual(await labels(inGltf), ['10 m']);
  assert.equal(await inGltf.page.$eval('#mesh-unit', (box) => box.selectedOptions[0].textContent), 'm, as its file says');
}

/** Around the line at a distance of 3: twice its length and a circle. */
export async function anOffsetAroundALine() {
  const page = await withLine();
  await withOffset(page, 3);
  const [told, ...others] = await offsets(page);
  assert.deepEqual(others, []);
  const length = Number(told.match(/^a loop, around the ends: ([\d.]+)$/)?.[1]);
  assert.ok(Math.abs(length - (20 + 6 * Math.PI)) < 0.05, told);
  assert.equal((await labels(page)).length, 2);
  await page.picture('offset');

  const smooth = await page.saved(() => page.act('save-curves'));
  const ours = await page.saved(() => page.act('save-offset')), theirs = join(dirname(ours), 'driver.json');
  talweg('offset', mesh('sheet'), '--curve', smooth, '--distance', '3', '--ends', 'open', '-o', theirs);
  assert.ok(farthest(curvesIn(ours), curvesIn(theirs)) < 1e-12);
  await page.page.evaluate(() => (document.getElementById('command-details').open = true));
  await page.page.waitForFunction(() => /\n/.test(document.getElementById('command').textContent));
  assert.match(await page.text('command'), /\ntalweg offset sheet\.off --curve sheet-smooth\.vtp --distance 3 --side both/);

  await page.act('cut-offset');
  await page.page.waitForSelector('#part-list li');
  assert.equal((await page.page.$$('#part-list li')).length, 2);
  await (await page.page.$('#part-list li:last-child button')).click();
  await page.page.waitForFunction(() => document.querySelectorAll('#part-list li').length === 1);
  await page.rest();
  await page.act('all-parts');
  assert.equal((await page.page.$$('#part-list li')).length, 2);
  const cut = await page.saved(() => page.act('save-mesh'));
  assert.ok(countIn(cut, 'face') > 2 * 30 * 30);
}

export async function oneSideAndNone() {
  const page = await withLine();
  await withOffset(page, 4);
  await choose(page, 'offset-side', 'left');
  assert.deepEqual(await offsets(page), ['open, left: 10']);
  await choose(page, 'offset-side', 'both');
  await choose(page, 'offset-caps', 'none');
  assert.deepEqual(await offsets(page), ['open, left: 10', 'open, right: 10']);
  // The offset follows the curve and is stored; if there is none, the page says why.
  await page.load();
  await page.page.waitForFunction(() => document.querySelectorAll('#offset-list li').length === 2);
  await page.rest();
  await write(page, 'offset-number', 300);
  assert.match(await page.text('trouble-offset'), /300/);
  assert.deepEqual(await offsets(page), []);
  await page.page.click('#offset-on');
  await page.rest();
  assert.equal(await page.text('trouble-offset'), '');
}

/** Edits of offsets are steps that can be undone, and leave the curves unchanged. */
export async function editsOfTheOffsetAreUndone() {
  const page = await withLine();
  const number = () => page.page.$eval('#offset-number', (box) => box.value);
  await withOffset(page, 3);
  const [atThree] = await offsets(page);
  await write(page, 'offset-number', 4);
  assert.notEqual((await offsets(page))[0], atThree);
  await page.page.focus('#view');
  await page.page.keyboard.down('Control');
  await page.key('z');
  assert.match(await page.text('told'), /Undid: Offset/);
  assert.equal(await number(), '3');
  assert.deepEqual(await offsets(page), [atThree]);
  await page.key('y');
  await page.page.keyboard.up('Control');
  assert.equal(await number(), '4');

  // A slider that is held is one step.
  const slider = await (await page.page.$('#offset')).boundingBox(), y = slider.y + slider.height / 2;
  await page.drag([[slider.x + slider.width / 2, y], [slider.x + slider.width / 4, y]]);
  assert.notEqual(await number(), '4');
  await page.act('undo');
  assert.equal(await number(), '4');
  await choose(page, 'offset-side', 'right');
  assert.deepEqual(await offsets(page), ['open, right: 10']);
  await page.page.click('#offset-on');
  await page.rest();
  assert.deepEqual(await offsets(page), []);
  await page.act('undo');
  assert.deepEqual(await offsets(page), ['open, right: 10']);

  await write(page, 'offset-number', 0);
  assert.equal(await page.text('trouble-offset'), 'The distance of the offset must be more than 0.');
  assert.equal(await number(), '4');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
}
