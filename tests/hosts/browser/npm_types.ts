// The types of the npm package, as a strict compiler sees them in a user's program.
import { openMesh, TalwegError, type Drawn, type Line, type Mesh, type Options, type Smoothed } from 'talweg';

const mesh: Mesh = await openMesh(new Float32Array(9), new Uint16Array(3), { repair: true });
const drawn: Drawn[] = [{ points: [mesh.at(0), { face: 0, barycentric: [0, 1, 0] }], closed: false }];
const options: Options = { tau: 2, ridges: 0.5, ridgeKind: 'convex', maxDeviation: null };
const smoothed: Smoothed = mesh.smooth(drawn, options);
const curve: Line = smoothed.curves[0]!;
const distances: Float64Array = curve.deviation;
const borders: Drawn[] = mesh.labels(new Int32Array(1));
const parts: number = mesh.cut(borders).parts;
const error = new TalwegError('It is wrong.', 'usage');
if (error.kind === 'mesh') console.log(distances, parts, mesh.draw(drawn), mesh.saveCurves('vtp').bytes.length);

// @ts-expect-error: there is no such option
mesh.smooth(drawn, { Tau: 1 });
// @ts-expect-error: a place needs barycentric coordinates
mesh.draw([{ points: [{ face: 0 }], closed: false }]);
// @ts-expect-error: there is no such kind
if (error.kind === 'meshes') mesh.dispose();
