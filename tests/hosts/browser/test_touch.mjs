// Fingers on an upright phone: one finger draws, two move the view.
import assert from 'node:assert/strict';
import { around, withMesh } from './places.mjs';

const phone = { width: 390, height: 780, touch: true };

async function stroke(page, points) {
  const { touchscreen } = page.page;
  const finger = await touchscreen.touchStart(...points[0]);
  for (let k = 1; k < points.length; ++k) {
    const [[a, b], [c, d]] = [points[k - 1], points[k]];
    for (let s = 1; s <= 8; ++s) await finger.move(a + ((c - a) * s) / 8, b + ((d - b) * s) / 8);
  }
  await finger.end();
  await page.rest();
}

export async function oneFingerDraws() {
  const page = await withMesh(phone);
  const [a, b, c] = await around(page, 40);
  await stroke(page, [a, b, c]);
  assert.match((await page.curves())[0], /^Curve 1 being drawn, \d\d points$/);
  await page.act('finish');
  assert.match((await page.curves())[0], /^Curve 1 open/);
  // The slider of τ is visible, and the hint is about fingers.
  const slider = await (await page.page.$('#tau')).boundingBox();
  assert.ok(slider.y > 0 && slider.y + slider.height <= phone.height, `τ is at ${slider.y}`);
  assert.match(await page.text('hint'), /τ below/);
  await page.picture('phone');
}

export async function tapsArePoints() {
  const page = await withMesh(phone);
  for (const at of (await around(page, 40)).slice(0, 3)) {
    await page.page.touchscreen.tap(...at);
    await page.rest();
  }
  await page.act('close');
  assert.deepEqual(await page.curves(), ['Curve 1 closed, 3 points']);
}

export async function twoFingersMoveTheView() {
  const page = await withMesh(phone);
  const [a, , c] = await around(page, 40);
  const before = await page.page.screenshot({ encoding: 'base64' });
  const { touchscreen } = page.page;
  const first = await touchscreen.touchStart(...a);
  const second = await touchscreen.touchStart(...c);
  for (let s = 1; s <= 5; ++s) {
    await first.move(a[0] - 4 * s, a[1]);
    await second.move(c[0] + 4 * s, c[1] + 6 * s);
  }
  await first.end();
  await second.end();
  await page.rest();
  assert.deepEqual(await page.curves(), []);
  assert.notEqual(await page.page.screenshot({ encoding: 'base64' }), before);
}

export async function thePanelIsBelowTheView() {
  const page = await withMesh(phone);
  const view = await (await page.page.$('#view')).boundingBox();
  const panel = await (await page.page.$('#panel')).boundingBox();
  assert.ok(panel.y >= view.y + view.height - 1);
  assert.ok(view.height > 0.5 * phone.height);
  const wide = await page.page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= phone.width, `the page is ${wide} pixels wide`);
}

/** A pen draws while a finger, or the palm, rests on the screen. */
export async function aPenDrawsAlways() {
  const page = await withMesh(phone);
  const client = await page.page.createCDPSession();
  const pen = (type, [x, y]) => client.send('Input.dispatchMouseEvent',
    { type, x, y, button: 'left', buttons: 1, clickCount: 1, pointerType: 'pen' });
  const [a, b, c, d] = await around(page, 40);
  const finger = await page.page.touchscreen.touchStart(...d);
  await pen('mousePressed', a);
  for (let s = 1; s <= 8; ++s) await pen('mouseMoved', [a[0] + ((b[0] - a[0]) * s) / 8, a[1]]);
  for (let s = 1; s <= 8; ++s) await pen('mouseMoved', [b[0], b[1] + ((c[1] - b[1]) * s) / 8]);
  await pen('mouseReleased', c);
  await finger.end();
  await page.rest();
  assert.match((await page.curves())[0], /^Curve 1 being drawn, \d\d points$/);
}
