// The page saves the driver's results for the same drawing, and can read them again.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { countIn, curvesIn, farthest, talweg } from './driver.mjs';
import { mesh, meanEdge } from './meshes.mjs';
import { around, withMesh } from './places.mjs';

async function saveAs(page, format) {
  await page.page.select('#curve-format', format);
  return page.saved(() => page.act('save-curves'));
}

async function stroked(closed = true) {
  const page = await withMesh();
  const [a, b, c, d] = await around(page);
  await page.drag(closed ? [a, b, c, d, a] : [a, c, b, d], { steps: 9 });
  if (!closed) await page.key('Enter');
  await page.rest();
  return page;
}

/** The driver smooths the drawing that the page saved, by the page's command line. */
async function bothWays(page) {
  const drawn = await saveAs(page, 'drawn.json');
  const ours = await saveAs(page, 'json');
  const theirs = join(dirname(ours), 'driver.json'), report = join(dirname(ours), 'driver-report.json');
  await page.page.evaluate(() => (document.getElementById('command-details').open = true));
  await page.page.waitForFunction(() => document.getElementById('command').textContent.startsWith('talweg'));
  const words = (await page.text('command')).split(' ').slice(1);
  const paths = { 'ball.off': mesh('ball'), [basename(drawn)]: drawn };
  const out = words.indexOf('-o');
  words[out + 1] = theirs;
  words[words.indexOf('--report') + 1] = report;
  talweg(...words.map((word) => paths[word] ?? word));
  return { ours, theirs, report };
}

/** A fair curve is a minimum; the search ends when steps are small compared with the edges. */
async function agree(page, tolerance = 1e-4 * meanEdge('ball')) {
  const { ours, theirs } = await bothWays(page);
  const distance = farthest(curvesIn(ours), curvesIn(theirs));
  assert.ok(distance <= tolerance, `${distance}, but ${tolerance} are allowed`);
  talweg('measure', mesh('ball'), ours);
}

export async function aStrokeAsTheDriverHasIt() {
  await agree(await stroked(false));
}

export async function aLoopAsTheDriverHasIt() {
  await agree(await stroked());
}

export async function clicksAsTheDriverHasThem() {
  const page = await withMesh();
  for (const at of await around(page)) await page.click(...at);
  await page.act('close');
  await agree(page);
}

export async function anotherTauAndABound() {
  const page = await stroked(false);
  await page.page.$eval('#tau-number', (box) => {
    box.value = '3';
    box.dispatchEvent(new Event('change'));
  });
  await page.rest();
  await agree(page);
  await page.act('undo');
  await page.page.click('#most-on');
  await page.rest();
  await agree(page);
}

/** The paper's method has no search, so only rounding differs. */
export async function thePapersMethodAsTheDriverHasIt() {
  const page = await stroked(false);
  const fair = await page.reported('length');
  await page.page.select('#method', 'paper');
  await page.rest();
  assert.notEqual(await page.reported('length'), fair);
  await agree(page, 1e-9);  // the ball's size is 3.3
  await page.picture('paper');
  await page.act('undo');
  assert.equal(await page.reported('length'), fair);
}

/** A face has the label 1 where the ball is in front: its border goes once around. */
export async function bordersOfLabelsBecomeSmooth() {
  const page = await withMesh();
  const lines = readFileSync(mesh('ball'), 'utf8').split('\n').map((line) => line.split(' ').map(Number));
  const [points, faces] = lines[1];
  const y = (v) => lines[2 + v][1];
  const labels = lines.slice(2 + points, 2 + points + faces)
    .map(([, a, b, c]) => (y(a) + y(b) + y(c) > 0 ? 1 : 0));
  const file = join(page.downloads, 'saved-ball.labels');
  writeFileSync(file, labels.join('\n'));
  await page.choose('choose-labels', file);
  await page.page.waitForFunction(() => document.querySelector('#curve-list li'));
  await page.rest();
  assert.deepEqual((await page.curves()).map((told) => told.includes('closed')), [true]);
  const [after, before] = (await page.text('reports')).match(/length([\d.]+).*?drawn ([\d.]+)/).slice(1).map(Number);
  assert.ok(after > 4 && after < before, `${before} became ${after}`);
  await page.picture('labels');
  await agree(page);
  await page.act('cut');
  await page.page.waitForSelector('#part-list li');
  assert.equal((await page.page.$$('#part-list li')).length, 2);
}

export async function theReportIsTheDrivers() {
  const page = await stroked(false);
  const { report } = await bothWays(page);
  const ours = JSON.parse(readFileSync(await page.saved(() => page.act('save-report')), 'utf8'));
  const theirs = JSON.parse(readFileSync(report, 'utf8'));
  for (const name of ['length_before', 'length_after', 'deviation_to_drawn_max', 'curvature_after']) {
    const [a, b] = [ours, theirs].map((r) => r[name] ?? r.curves?.[0]?.[name]);
    assert.ok(Math.abs(a - b) <= 1e-4 * Math.abs(b), `${name}: ${a} and ${b}`);
  }
}

export async function everyFormatIsRead() {
  const page = await stroked(false);
  const formats = await page.page.$$eval('#curve-format option', (all) => all.map((o) => o.value));
  for (const format of formats) {
    const file = await saveAs(page, format);
    talweg('measure', mesh('ball'), file);
    const before = (await page.curves()).length;
    await page.choose('choose-curves', file);
    await page.page.waitForFunction((n) => document.querySelectorAll('#curve-list li').length > n, {}, before);
    await page.rest();
    await page.act('undo');
    assert.equal((await page.curves()).length, before, format);
  }
}

export async function theCutIsTheDrivers() {
  const page = await stroked();
  const curve = await saveAs(page, 'json');
  await page.act('cut');
  await page.page.waitForSelector('#part-list li');
  await page.rest();
  assert.equal((await page.page.$$('#part-list li')).length, 2);
  await page.picture('cut');
  const ours = await page.saved(() => page.act('save-mesh'));
  const theirs = join(dirname(ours), 'driver.ply');
  talweg('cut', mesh('ball'), '--curve', curve, '--open', '-o', theirs);
  for (const element of ['vertex', 'face']) assert.equal(countIn(ours, element), countIn(theirs, element), element);

  // The parts together are the whole mesh, each in its own file.
  const parts = await page.savedAll(2, () => page.act('save-parts'));
  assert.deepEqual(parts.map((path) => basename(path)), ['ball-part-1.ply', 'ball-part-2.ply']);
  assert.equal(parts.reduce((sum, path) => sum + countIn(path, 'face'), 0), countIn(ours, 'face'));
  for (const path of parts) assert.equal(JSON.parse(talweg('info', '--json', path)).components, 1);

  // One part with a lid is closed.
  await page.page.click('#lids');
  await (await page.page.$('#part-list li button')).click();
  await page.page.waitForFunction(() => document.querySelectorAll('#part-list li').length === 1);
  await page.rest();
  await page.picture('kept');
  const kept = await page.saved(() => page.act('save-mesh'));
  assert.match(talweg('info', kept), /closed|watertight|no boundary/i);
  await page.key('Escape');  // a button of the panel has the focus
  assert.equal((await page.curves()).length, 1);
}

/** A row for each point that the page saves, with the report's length at the end. */
export async function aTableForSpreadsheets() {
  const page = await stroked(false);
  await page.page.evaluate(() => {
    navigator.clipboard.writeText = async (text) => (globalThis.copied = text);
  });
  await page.act('copy-table');
  const rows = (await page.page.evaluate(() => globalThis.copied)).trimEnd().split('\r\n').map((row) => row.split(','));
  assert.deepEqual(rows.shift(), ['curve', 'length', 'x', 'y', 'z', 'turning', 'deviation']);
  const [{ points }] = curvesIn(await saveAs(page, 'json'));
  assert.equal(rows.length, points.length);
  rows.forEach(([, , ...cells], k) => points[k].xyz.forEach((x, i) => assert.ok(Math.abs(x - cells[i]) < 1e-12)));
  const report = JSON.parse(readFileSync(await page.saved(() => page.act('save-report')), 'utf8'));
  assert.ok(Math.abs(rows.at(-1)[1] - report.length_after) < 1e-9 * report.length_after);
  assert.ok(rows.every(([, , , , , turning, deviation]) => turning !== '' && deviation !== ''));
}

export async function aPicture() {
  const page = await stroked();
  const bytes = readFileSync(await page.saved(() => page.act('save-picture')));
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
}
