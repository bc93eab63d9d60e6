// Places of clicks in the tests.
import { mesh } from './meshes.mjs';
import { openPage } from './page.mjs';

/** The page with the test's mesh open. */
export async function withMesh(options) {
  const page = await openPage(options);
  await page.openMesh(mesh('ball'));
  return page;
}

/** Four places around the middle of the view, all on the mesh. */
export async function around(page, size = 60) {
  const { x, y } = await page.middle();
  return [[x - size, y - size], [x + size, y - size], [x + size, y + size], [x - size, y + size]];
}

/** Moves the mouse up and down until it is over a curve; returns the place. */
export async function findLine(page, x, y) {
  for (const dy of [0, -4, 4, -8, 8, -12, 12, -16, 16, -20, 20, -24, 24]) {
    await page.page.mouse.move(x, y + dy);
    await page.rest();
    if ((await page.text('hint')).includes('on the curve')) return [x, y + dy];
  }
  throw new Error('The curve is not found.');
}
