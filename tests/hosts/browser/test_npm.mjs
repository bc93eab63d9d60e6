// The npm package in Node gives the driver's curves, lengths known by hand, and sentences for errors.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { curvesIn, talweg } from './driver.mjs';
import { arrays, mesh as meshFile, sheetVertex } from './meshes.mjs';
import { built, installed, load, run } from './npm_package.mjs';

const { openMesh } = await load();
const source = process.env.TALWEG_PAGE_SOURCE;

const corners = [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1];
const triangles = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
const upper = [1, 1, 1, 1, 0, 0, 0, 0];

function near(own, expected, within = 1e-9) {
  assert.ok(Math.abs(own - expected) <= within, `${own} is not ${expected}`);
}

async function opened(kind, options) {
  const { positions, indices } = arrays(kind);
  return openMesh(positions, indices, options);
}

const through = (mesh, ...vertices) => vertices.map((vertex) => mesh.at(vertex));

/** A stroke on the roof beside its crease, which lies at y = 15. */
const besideTheCrease = [{
  points: Array.from({ length: 21 }, (_, k) => sheetVertex(5 + k, 16)), closed: false, painted: true,
}];

/** The halves of an octahedron meet in a square with sides of the length sqrt(2). */
export async function bordersOfLabels() {
  const mesh = await openMesh(corners, triangles);
  const [border] = mesh.labels(upper);
  assert.ok(border.closed && border.painted);
  const { curves: [curve] } = mesh.smooth([border]);
  near(curve.report.drawnLength, 4 * Math.SQRT2);
  assert.equal(mesh.cut([border]).parts, 2);
}

/** Between the centres of two faces of an octahedron the shortest way is twice a third of their height. */
export async function aDrawnCurveIsShortest() {
  const mesh = await openMesh(new Float32Array(corners), new Uint16Array(triangles));
  const centre = (face) => ({ face, barycentric: [1 / 3, 1 / 3, 1 / 3] });
  const [way] = mesh.draw([{ points: [centre(0), centre(1)], closed: false }]);
  near(way.report.length, 2 * Math.sqrt(6) / 6);
}

/** The driver draws through the same vertices, and smooths and measures with its own mesh. */
export async function curvesAreTheDrivers() {
  const mesh = await opened('ball'), file = meshFile('ball'), folder = mkdtempSync(join(tmpdir(), 'talweg-npm-'));
  const at = (name) => join(folder, name);
  const vertices = [500, 516, 532], edge = Math.PI / 24;
  for (const closed of [true, false]) {
    const drawn = [{ points: through(mesh, ...vertices), closed }];
    const { curves: [curve] } = mesh.smooth(drawn, { tau: 2 });
    talweg('draw', file, '--through', vertices.join(','), ...(closed ? ['--closed'] : []), '-o', at('drawn.json'));
    talweg('smooth', file, '--curve', at('drawn.json'), '--tau', '2', '-o', at('smooth.json'), '--report', at('report.json'));
    const [{ points }] = curvesIn(at('smooth.json'));
    const report = JSON.parse(readFileSync(at('report.json'), 'utf8'));
    assert.equal(curve.closed, closed);
    assert.equal(curve.positions.length, 3 * points.length);
    points.forEach(({ xyz }, k) => near(Math.hypot(...xyz.map((x, i) => x - curve.positions[3 * k + i])), 0, 1e-4 * edge));
    near(curve.report.length, report.length_after, 1e-4 * edge);
    near(Math.max(...curve.deviation), report.deviation_to_drawn_max, 1e-4 * edge);
    talweg('cut', file, '--curve', at('smooth.json'), '--open', '-o', at('cut.ply'));
    const { components } = JSON.parse(talweg('info', '--json', at('cut.ply')));
    assert.equal(mesh.cut(drawn, { tau: 2 }).parts, components);
  }
}

/** On a sheet the offset of a straight line runs beside it. */
export async function offsetsAndFiles() {
  const mesh = await opened('sheet'), folder = mkdtempSync(join(tmpdir(), 'talweg-npm-'));
  mesh.smooth([{ points: [sheetVertex(5, 10), sheetVertex(25, 10)], closed: false }]);
  const { curves: [left], sides } = mesh.offset(2, { side: 'left', caps: 'none' });
  assert.deepEqual(sides, ['left']);
  for (let k = 1; k < left.positions.length; k += 3) near(left.positions[k], 12);
  const { name, bytes } = mesh.saveCurves('json');
  writeFileSync(join(folder, name), bytes);
  near(curvesIn(join(folder, name))[0].points[0].xyz[0], 5);
  writeFileSync(join(folder, 'drawn.json'), mesh.saveCurves('drawn.json').bytes);
  assert.equal(curvesIn(join(folder, 'drawn.json'))[0].points.at(-1).xyz[0], 25);
  writeFileSync(join(folder, 'mesh.ply'), mesh.saveMesh('.ply').bytes);
  assert.equal(JSON.parse(talweg('info', '--json', join(folder, 'mesh.ply'))).faces, mesh.faces);
}

/** A stroke one edge beside the crease of a roof is moved onto it. */
export async function ridgesAttract() {
  const mesh = await opened('roof');
  const middle = ({ positions }) => positions[3 * Math.floor(positions.length / 6) + 1];
  const [without, attracted] = [0, 1].map((ridges) => mesh.smooth(besideTheCrease, { ridges, ridgeKind: 'convex' }).curves[0]);
  near(middle(without), 16, 0.5);
  near(middle(attracted), 15, 0.2);
  assert.equal(without.report.ridges, null);
  assert.ok(attracted.report.ridges.moved > 0.5);
}

/** A mesh with a repeated face is refused, and repaired on request. */
export async function defectsAndRepair() {
  await assert.rejects(opened('twice'), { name: 'TalwegError', kind: 'mesh', message: /1 face repeats/ });
  const mesh = await opened('twice', { repair: true });
  assert.match(mesh.changes.join(' '), /dropped/);
  assert.equal(mesh.draw([{ points: through(mesh, 3, 40), closed: false }]).length, 1);
}

async function refusesArrays() {
  const say = async (positions, indices, kind, message) =>
    assert.rejects(openMesh(positions, indices), { name: 'TalwegError', kind, message });
  await say(null, triangles, 'usage', /^The positions are not an array/);
  await say('000', triangles, 'usage', /^The positions are not an array/);
  await say(corners.slice(1), triangles, 'usage', /^There are 17 positions: give three for each vertex/);
  await say(corners, [], 'usage', /^There are 0 indices/);
  await say(corners.with?.(7, NaN) ?? Object.assign([...corners], { 7: NaN }), triangles, 'mesh',
    /^Coordinate 1 of vertex 2 is NaN: give finite numbers\.$/);
  await say(corners, [0, 2, 6], 'mesh', /^Corner 2 of face 0 is 6: vertices are counted from 0 to 5\.$/);
  await say(corners, [0, 2, -1], 'mesh', /^Corner 2 of face 0 is -1/);
  await say(corners, [0, 2, 2.5], 'mesh', /^Corner 2 of face 0 is 2\.5/);
  await say(corners, [0n, 2n, 4n], 'mesh', /^Corner 0 of face 0 is 0: /);
}

function refusesCurves(mesh) {
  const say = (points, message) =>
    assert.throws(() => mesh.draw([{ points, closed: false }]), { name: 'TalwegError', kind: 'curve', message });
  const at = (face, ...barycentric) => ({ face, barycentric });
  say([mesh.at(0), at(8, 1, 0, 0)], /^Point 1 of curve 0 is on face 8: faces are counted from 0 to 7\.$/);
  say([mesh.at(0), at(1, NaN, 0, 1)], /^Point 1 of curve 0 has the barycentric coordinates \[NaN, 0, 1\]/);
  say([mesh.at(0), at(1, 2, -1, 0)], /coordinates \[2, -1, 0\]: give three numbers of 0 or more with the sum 1\.$/);
  say([mesh.at(0), { face: 1 }], /coordinates \[\]/);
  say([mesh.at(0), null], /^Point 1 of curve 0 is on face undefined/);
  say([mesh.at(0)], /^Curve 0 has only one point: give two at least\.$/);
  say([mesh.at(0), mesh.at(0)], /^A curve needs at least two different points/);
}

function refusesArguments(mesh, drawn) {
  const say = (call, message) => assert.throws(call, { name: 'TalwegError', kind: 'usage', message });
  say(() => mesh.smooth(null), /^The curves are not an array/);
  say(() => mesh.smooth([{}]), /^Curve 0 has no list of points/);
  say(() => mesh.smooth(drawn, { Tau: 1 }), /^There is no option Tau: the options are tau, /);
  say(() => mesh.smooth(drawn, { tau: NaN }), /^The option tau is NaN: give a number of 0 or more\.$/);
  say(() => mesh.smooth(drawn, { ridges: 2 }), /^The option ridges is 2: give a number from 0 to 1\.$/);
  say(() => mesh.smooth(drawn, 2), /^The options are 2/);
  say(() => mesh.at(6), /^There is no vertex 6 in a triangle: vertices are counted from 0 to 5\.$/);
  say(() => mesh.labels([1]), /There are 1 labels, and the mesh has 8 faces/);
  say(() => mesh.labels(upper.map((x) => x / 2)), /^The label of face 0 is 0\.5/);
  say(() => mesh.offset(NaN), /^The distance is NaN/);
  say(() => mesh.offset(0.1), /^There is no smoothed curve yet/);
  say(() => mesh.saveMesh('../x.ply'), /^The format is "\.\.\/x\.ply"/);
  assert.throws(() => mesh.saveMesh('xyz'), { kind: 'file', message: /^Cannot write mesh\.xyz/ });
}

export async function badArgumentsAreRefused() {
  await refusesArrays();
  const mesh = await openMesh(corners, triangles);
  const drawn = [{ points: through(mesh, 0, 1), closed: false }];
  refusesCurves(mesh);
  refusesArguments(mesh, drawn);
  near(mesh.draw(drawn)[0].report.length, mesh.smooth(drawn).curves[0].report.length, 1);  // it still works
  mesh.dispose();
  mesh.dispose();
  for (const call of [() => mesh.draw(drawn), () => mesh.cut(drawn), () => mesh.saveMesh('ply'), () => mesh.labels(upper)]) {
    assert.throws(call, { name: 'TalwegError', kind: 'usage', message: 'The mesh was disposed of: open it again.' });
  }
}

export async function meshesAreApart() {
  const [one, other] = await Promise.all([openMesh(corners, triangles), openMesh(corners.map((x) => 2 * x), triangles)]);
  const length = (mesh) => mesh.draw(mesh.labels(upper))[0].report.length;
  near(length(one), 4 * Math.SQRT2);
  near(length(other), 8 * Math.SQRT2);
  one.dispose();
  near(length(other), 8 * Math.SQRT2);
}

export async function aDisposedMeshLeavesItsMemory() {
  const open = async () => (await openMesh(corners, triangles)).dispose();
  for (let k = 0; k < 50; ++k) await open();
  const before = process.memoryUsage().rss;
  for (let k = 0; k < 1000; ++k) await open();
  const grown = (process.memoryUsage().rss - before) / 2 ** 20;
  assert.ok(grown < 50, `1000 meshes took ${grown} MiB`);  // a module has 16 MiB
}

const exampleIn = (file) => /```js\n(.*?)```/s.exec(readFileSync(file, 'utf8'))[1];

/** Packed and installed by npm, it runs the example, and its types hold. */
export async function installedItRuns() {
  const folder = installed();
  const said = run(folder, process.execPath, 'node.mjs');
  assert.match(said, /^length \d\.\d{3}, at most 0\.\d{3} from the drawing\n2 parts\n$/);
  assert.equal(JSON.parse(talweg('info', '--json', join(folder, 'ball-cut.ply'))).components, 2);
  writeFileSync(join(folder, 'readme.mjs'), exampleIn(join(built, 'README.md')));
  const [length, , parts] = run(folder, process.execPath, 'readme.mjs').split(/\s/).map(Number);
  near(length, 2 * Math.sqrt(6) / 6);
  assert.equal(parts, 2);
  const page = exampleIn(fileURLToPath(new URL('../../../docs/npm.md', import.meta.url)));
  writeFileSync(join(folder, 'page.mjs'), `import { ball } from './ball.js';\nconst { positions, indices } = ball();\n${page}`);
  run(folder, process.execPath, 'page.mjs');
  const types = new URL('npm_types.ts', import.meta.url);
  writeFileSync(join(folder, 'types.ts'), readFileSync(types));
  run(folder, process.execPath, join(source, 'node_modules/typescript/bin/tsc'), '--noEmit', '--strict', '--module', 'nodenext',
    '--target', 'es2022', 'types.ts');
}
