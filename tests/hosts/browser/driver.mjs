// Compares the page's saved files with the driver's results.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

/** Runs `talweg`; throws with its sentence if it fails. */
export function talweg(...args) {
  return execFileSync(process.env.TALWEG_DRIVER, ['--quiet', ...args], { encoding: 'utf8' });
}

/** The points of the curves in a file of Talweg's JSON. */
export function curvesIn(path) {
  return JSON.parse(readFileSync(path, 'utf8')).curves;
}

/** The number of elements of a kind in a PLY file. */
export function countIn(path, element) {
  const head = readFileSync(path, 'latin1').slice(0, 4000);
  return Number(head.match(new RegExp(`element ${element} (\\d+)`))?.[1]);
}

/** The largest distance between corresponding points; the curves must have equal numbers of
   points. */
export function farthest(some, others) {
  assert.deepEqual(some.map((c) => c.points.length), others.map((c) => c.points.length));
  let most = 0;
  some.forEach((curve, c) => curve.points.forEach(({ xyz }, k) => {
    const other = others[c].points[k].xyz;
    most = Math.max(most, Math.hypot(...xyz.map((x, i) => x - other[i])));
  }));
  return most;
}
