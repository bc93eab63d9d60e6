// Node: a closed curve through four vertices, smoothed; then the mesh is cut along it.
// npm install talweg-npm-VERSION.tgz, then node node.mjs.
import { writeFileSync } from 'node:fs';
import { openMesh, TalwegError } from 'talweg';
import { ball } from './ball.js';

try {
  const { positions, indices } = ball();
  const mesh = await openMesh(positions, indices);
  const drawn = [{ points: [1210, 1230, 1250, 1270].map((vertex) => mesh.at(vertex)), closed: true }];
  const { curves: [curve] } = mesh.smooth(drawn, { tau: 2 });
  console.log(`length ${curve.report.length.toFixed(3)}, at most ${Math.max(...curve.deviation).toFixed(3)} from the drawing`);
  console.log(`${mesh.cut(drawn, { tau: 2 }).parts} parts`);
  writeFileSync('ball-cut.ply', mesh.saveMesh('ply').bytes);
  writeFileSync('ball-smooth.vtp', mesh.saveCurves('vtp').bytes);
  mesh.dispose();
} catch (error) {
  if (!(error instanceof TalwegError)) throw error;
  console.error(error.message);
  process.exitCode = 1;
}
