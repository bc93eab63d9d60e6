// The engine's module in node gives the driver's curves, deviations and cuts, and sentences for
// errors.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { mesh } from './meshes.mjs';
import { talwegModule } from './talweg_module.mjs';

const page = process.env.TALWEG_PAGE;
const driver = process.env.TALWEG_DRIVER;

const at = (face, barycentric = [0.25, 0.5, 0.25]) => ({ face, barycentric });

/** The sample, opened, with an editor; saved files go into `folder`. */
async function begun() {
  const { call, memory } = await talwegModule(page);
  const folder = mkdtempSync(join(tmpdir(), 'talweg-page-'));
  const sample = call('sample');
  const mesh = join(folder, sample.name);
  writeFileSync(mesh, sample.bytes);
  const info = call('open', [sample.name, false], sample.bytes);
  const number = call('editor.new');
  const edit = (name, ...args) => call(`editor.${number}.${name}`, args);
  const saved = (kind, format) => {
    const { name, bytes } = call(kind, [format]);
    writeFileSync(join(folder, name), bytes);
    return join(folder, name);
  };
  const talweg = (...args) => execFileSync(driver, ['--quiet', ...args], { encoding: 'utf8' });
  return { call, memory, folder, mesh, info, edit, saved, talweg };
}

/** Four clicks around the stone, closed or open. */
function drawn(edit, closed) {
  for (const face of [100, 30000, 52000, 70000]) edit('addPoint', at(face));
  edit(closed ? 'closeCurve' : 'finishCurve');
  return edit('drawing');
}

/** The same drawing painted: many points that are not way-points. */
function painted(call, edit) {
  const [line] = call('draw', [drawn(edit, true)]);
  edit('clear');
  const n = line.faces.length;
  for (let k = 0; k < n; k += 3) {
    edit('paintPoint', { face: line.faces[k], barycentric: [...line.barycentric.slice(3 * k, 3 * k + 3)] });
  }
  edit('closeCurve');
  return edit('drawing');
}

const curvesIn = (file) => JSON.parse(readFileSync(file, 'utf8')).curves;

function expectNear(own, other, tolerance, what) {
  assert.ok(Math.abs(own - other) <= tolerance, `${what}: ${own} here, ${other} by the driver`);
}

function compareWithDriver({ saved, talweg, folder, mesh, info }, smoothed, args) {
  const own = curvesIn(saved('saveCurves', 'json'));
  const [result, report] = [join(folder, 'native.json'), join(folder, 'native-report.json')];
  talweg('smooth', mesh, '--curve', saved('saveCurves', 'drawn.json'), ...args, '-o', result, '--report', report);
  const other = curvesIn(result);
  assert.equal(own.length, other.length);
  own.forEach((curve, c) => {
    assert.equal(curve.points.length, other[c].points.length, 'points of the curve');
    curve.points.forEach((point, k) => {
      const q = other[c].points[k].xyz;
      // A fair curve is a flat minimum of its energy: mathematical libraries differ in the last
      // digits.
      expectNear(Math.hypot(...point.xyz.map((x, i) => x - q[i])), 0, 1e-4 * info.meanEdge, `point ${k}`);
    });
  });
  const [here, there] = [JSON.parse(smoothed.report), JSON.parse(readFileSync(report, 'utf8'))];
  for (const key of ['length_before', 'length_after', 'deviation_to_drawn_max', 'deviation_from_drawn_max']) {
    expectNear(here[key], there[key], 1e-4 * info.meanEdge, key);
  }
  for (const key of ['faces', 'vertices', 'termination', 'potential', 'engine', 'points_before', 'closed']) {
    assert.deepEqual(here[key], there[key], key);
  }
}

export async function curvesAreTheDrivers() {
  const all = await begun();
  for (const closed of [false, true]) {
    all.edit('clear');
    const smoothed = all.call('smooth', [drawn(all.edit, closed), 'rests']);
    compareWithDriver(all, smoothed, ['--tau', '1']);
  }
}

export async function strokesAreTheDrivers() {
  const all = await begun();
  painted(all.call, all.edit);
  all.edit('setTau', 2);
  compareWithDriver(all, all.call('smooth', [all.edit('drawing'), 'rests']), ['--tau', '2']);
  all.edit('setMaxDeviation', 0.5);
  compareWithDriver(all, all.call('smooth', [all.edit('drawing'), 'rests']), ['--max-deviation', '0.5']);
}

export async function cutsAreTheDrivers() {
  const { call, edit, saved, talweg, mesh, folder } = await begun();
  const drawing = painted(call, edit);
  const cut = call('cut', [drawing]);
  assert.equal(cut.parts, 2);
  assert.equal(cut.side.length, cut.triangles.length / 3);
  assert.deepEqual([...new Set(cut.side)], [0, 1]);

  talweg('cut', mesh, '--curve', saved('saveCurves', 'json'), '--open', '-o', join(folder, 'native-cut.ply'));
  const info = (file) => JSON.parse(talweg('info', '--json', file));
  const [own, other] = [info(saved('saveMesh', 'ply')), info(join(folder, 'native-cut.ply'))];
  for (const key of ['faces', 'vertices', 'edges', 'components', 'boundary_loops']) {
    assert.equal(own[key], other[key], key);
  }
  const kept = call('keep', [0, true]);
  assert.equal(kept.parts, 1);
  assert.equal(info(saved('saveMesh', 'ply')).boundary_loops, 0);
}

export async function curvesComeBack() {
  const { call, edit, saved } = await begun();
  drawn(edit, true);
  edit('setPinned', 0, 1, true);
  const drawing = edit('drawing');
  call('smooth', [drawing, 'rests']);
  const file = saved('saveCurves', 'drawn.json');
  const [back] = call('readCurves', ['drawn.json'], readFileSync(file));
  assert.equal(back.closed, true);
  assert.deepEqual(back.points.map(({ face }) => face), drawing.curves[0].points.map(({ face }) => face));
  for (const point of back.points) assert.equal(point.exact, 0);
}

export async function editsCanBeUndone() {
  const { edit } = await begun();
  drawn(edit, false);
  edit('beginGesture', 'Drag');
  edit('movePoint', 0, 1, at(30010));
  edit('movePoint', 0, 1, at(30020));
  edit('endGesture');
  assert.equal(edit('drawing').curves[0].points[1].face, 30020);
  assert.equal(edit('undo'), 'Drag');
  assert.equal(edit('drawing').curves[0].points[1].face, 30000);
  assert.equal(edit('redo'), 'Drag');
  while (edit('undo') !== null);
  assert.deepEqual(edit('drawing').curves, []);
  assert.equal(edit('undoName'), null);
}

export async function badArgumentsAreRefused() {
  const { call, edit } = await begun();
  assert.throws(() => edit('finishCurve'), /\w+.*\.$/);
  assert.throws(() => call('open', ['broken.ply', false], new TextEncoder().encode('ply\nformat x')),
    /^Error: Cannot read broken\.ply, line 2: /);
  assert.throws(() => call('saveCurves', ['json']), /There is no smoothed curve yet/);
  assert.throws(() => call('labels', [false]), /no labels/);
  // The earlier mesh is still open.
  assert.equal(call('draw', [drawn(edit, false)]).length, 1);
  const twice = 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 2\n3 0 2 3\n';
  const info = call('open', ['twice.off', false], new TextEncoder().encode(twice));
  assert.match(info.defects, /\w/);
  assert.ok(info.repair.length > 0);
  assert.equal(call('open', ['twice.off', true], new TextEncoder().encode(twice)).defects, null);
}

/** The plugins for drawing and smoothing are in one module: the second uses the mesh that the first
   has opened. */
export async function aMeshIsOpenedOnce() {
  const { call, memory } = await talwegModule(page);
  call('open', ['large.off', false], readFileSync(mesh('large')));
  const opened = memory();
  call('leg', [at(100), at(200)]);
  assert.ok(memory() < 1.3 * opened, `${opened} MiB became ${memory()} MiB`);
}
