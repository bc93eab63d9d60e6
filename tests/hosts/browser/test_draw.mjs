// Drawing with the mouse.
import assert from 'node:assert/strict';
import { mesh } from './meshes.mjs';
import { openPage } from './page.mjs';
import { around, findLine, withMesh } from './places.mjs';

export async function anOpenCurveFromClicks() {
  const page = await withMesh();
  const [a, b, c] = await around(page);
  for (const at of [a, b, c]) await page.click(...at);
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 3 points']);
  await page.page.mouse.move(...(await around(page))[3]);
  await page.picture('leg');
  await page.key('Enter');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  assert.ok((await page.reported('length')) > 0);
  await page.picture('open');
}

export async function aClickOnTheFirstPointCloses() {
  const page = await withMesh();
  const corners = await around(page);
  for (const at of [...corners, corners[0]]) await page.click(...at);
  assert.deepEqual(await page.curves(), ['Curve 1 closed, 4 points']);
}

export async function keysWhileDrawing() {
  const page = await withMesh();
  const [a, b, c, d] = await around(page);
  for (const at of [a, b, c]) await page.click(...at);
  await page.key('Backspace');
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 2 points']);
  await page.click(...d);
  await page.key('Escape');
  assert.deepEqual(await page.curves(), []);
  await page.act('undo');
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 3 points']);
}

export async function aDoubleClickEnds() {
  const page = await withMesh();
  const [a, b] = await around(page);
  await page.click(...a);
  await page.page.mouse.click(...b, { count: 2 });
  await page.rest();
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
}

export async function aPaintedStroke() {
  const page = await withMesh();
  const [a, b, c] = await around(page);
  await page.drag([a, b, c], { steps: 20 });
  await page.key('Enter');
  const [told] = await page.curves();
  assert.match(told, /^Curve 1 open, \d+ points$/);
  assert.ok(Number(told.match(/(\d+) points/)[1]) > 15, told);
  assert.ok((await page.reported('farthest apart')) > 0);
  // A stroke is one step of undo.
  await page.act('undo');
  await page.act('undo');
  assert.deepEqual(await page.curves(), []);
}

export async function aStrokeThatComesBackCloses() {
  const page = await withMesh();
  const corners = await around(page);
  await page.drag([...corners, corners[0]], { steps: 10 });
  assert.match((await page.curves())[0], /^Curve 1 closed/);
  await page.picture('stroke');
}

export async function endsThatMeet() {
  const page = await withMesh();
  const [a, b, c, d] = await around(page);
  const [x, y] = [(a[0] + b[0]) / 2, a[1]];
  await page.drag([[x, y], b, c, d, a, [x + 25, y + 3]], { steps: 12 });
  await page.key('Enter');
  assert.match((await page.curves())[0], /^Curve 1 open/, 'as it was drawn');
  assert.match(await page.text('notes'), /taken as a loop/);
  const length = await page.reported('length');
  await page.page.select('#ends', 'open');
  await page.rest();
  assert.doesNotMatch(await page.text('notes'), /taken as a loop/);
  assert.notEqual(await page.reported('length'), length);
  await page.act('undo');
  assert.match(await page.text('notes'), /taken as a loop/);
  assert.equal(await page.reported('length'), length);
}

export async function clicksBesideClicks() {
  const page = await withMesh();
  const [a, b, c] = await around(page);
  const beside = [b[0] - 40, b[1] + 10];
  for (const at of [a, b, beside, c]) await page.click(...at);
  await page.key('Enter');
  assert.doesNotMatch(await page.text('notes'), /merged with that point/);
  const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
  const share = apart(b, beside) / (apart(a, b) + apart(b, beside) + apart(beside, c));
  await page.page.type('#click-distance', String(1.5 * share * await page.reported('length')));
  await page.key('Enter');
  assert.match(await page.text('notes'), /merged with that point/);
}

export async function theSlider() {
  const page = await withMesh();
  const [a, b, c, d] = await around(page);
  await page.drag([a, c, b, d], { steps: 10 });
  await page.key('Enter');
  const before = await page.reported('length');
  const box = await (await page.page.$('#tau')).boundingBox();
  const y = box.y + box.height / 2;
  await page.drag([[box.x + 0.32 * box.width, y], [box.x + 4, y]]);
  const after = await page.reported('length');
  assert.ok(after < before, `${after} is not shorter than ${before}`);
  // The whole movement of the slider is one step of undo.
  await page.act('undo');
  assert.equal(await page.reported('length'), before);
}

export async function aDraggedPoint() {
  const page = await withMesh();
  const corners = await around(page);
  for (const at of corners) await page.click(...at);
  await page.key('Enter');
  const before = await page.reported('length');
  const [x, y] = corners[1];
  await page.drag([[x, y], [x + 30, y - 30]]);
  const after = await page.reported('length');
  assert.ok(after > before, `${after} is not longer than ${before}`);
  await page.act('undo');
  assert.equal(await page.reported('length'), before);
  await page.act('redo');
  assert.equal(await page.reported('length'), after);
}

export async function insertPinRemove() {
  const page = await withMesh();
  const [a, b] = await around(page);
  await page.click(...a);
  await page.click(...b);
  await page.key('Enter');
  const middle = await findLine(page, (a[0] + b[0]) / 2, a[1]);
  await page.click(...middle);
  assert.deepEqual(await page.curves(), ['Curve 1 open, 3 points']);
  await page.act('pin');
  assert.equal(await page.page.$eval('[data-act="pin"]', (e) => e.getAttribute('aria-pressed')), 'true');
  await page.picture('pinned');
  await page.page.keyboard.down('Shift');
  await page.click(...middle);
  await page.page.keyboard.up('Shift');
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
}

export async function theViewTurnsAndTheDrawingStays() {
  const page = await withMesh();
  const [a, b] = await around(page);
  for (const at of [a, b]) await page.click(...at);
  await page.key('Enter');
  const { x, y } = await page.middle();
  const before = await page.page.screenshot({ encoding: 'base64' });
  await page.drag([[x, y], [x + 80, y + 10]], { button: 'right' });
  assert.notEqual(await page.page.screenshot({ encoding: 'base64' }), before);
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
}

/** A click that no curve can reach would keep all curves from being smoothed. */
export async function anotherPartIsNotReached() {
  const page = await openPage();
  await page.openMesh(mesh('pair'));
  const { x, y } = await page.middle();
  await page.click(x - 150, y);
  await page.click(x + 150, y);
  assert.deepEqual(await page.curves(), ['Curve 1 being drawn, 1 point']);
  assert.match(await page.text('trouble-drawing'), /another part of the mesh/);
  await page.click(x - 120, y + 30);
  assert.equal(await page.text('trouble-drawing'), '');
  await page.key('Enter');
  await page.drag([[x - 120, y + 30], [x + 150, y]]);
  assert.deepEqual(await page.curves(), ['Curve 1 open, 2 points']);
  assert.equal(await page.row('farthest apart'), '0');
}

/** With software rendering 640,000 faces take long: a coarser mesh is shown while the view turns,
   and the whole mesh at rest. */
export async function aLargeMeshTurnsCoarsely() {
  const page = await openPage();
  await page.openMesh(mesh('large'));
  const { x, y } = await page.middle();
  const shown = (what) => page.page.waitForSelector(`#canvas[data-mesh="${what}"]`, { timeout: 120_000 });
  await shown('whole');
  await page.page.mouse.move(x, y);
  await page.page.mouse.down({ button: 'right' });
  for (let k = 1; (await page.page.$('#canvas[data-mesh="coarse"]')) === null; ++k) {
    assert.ok(k < 600, 'no coarser mesh was drawn');
    await page.page.mouse.move(x + (k % 2), y);
  }
  await page.picture('turning');
  await page.page.mouse.up({ button: 'right' });
  await shown('whole');
  await page.picture('turned');
}
