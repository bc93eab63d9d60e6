// Makes small meshes for the tests.
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folder = mkdtempSync(join(tmpdir(), 'talweg-meshes-'));

/** A ball with dents, of rings of triangles. */
function ball(rings = 24) {
  const around = 2 * rings, points = [[0, 0, 1]], faces = [];
  for (let i = 1; i < rings; ++i) {
    for (let j = 0; j < around; ++j) {
      const t = (Math.PI * i) / rings, p = (2 * Math.PI * j) / around;
      const r = 1 + 0.06 * Math.sin(3 * t) * Math.cos(4 * p);
      points.push([r * Math.sin(t) * Math.cos(p), r * Math.sin(t) * Math.sin(p), r * Math.cos(t)]);
    }
  }
  points.push([0, 0, -1]);
  const id = (i, j) => (i === 0 ? 0 : i === rings ? points.length - 1 : 1 + (i - 1) * around + (j % around));
  for (let i = 0; i < rings; ++i) {
    for (let j = 0; j < around; ++j) {
      const [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
      if (i < rings - 1) faces.push([a, b, c]);
      if (i > 0) faces.push([a, c, d]);
    }
  }
  return { points, faces };
}

/** A ball with a face twice, which is not a surface until repaired. */
function twice() {
  const { points, faces } = ball(8);
  return { points, faces: [...faces, faces[20]] };
}

/** A face with an index out of range. */
function broken() {
  const { points, faces } = ball(4);
  return { points, faces: [...faces, [0, 1, 100000]] };
}

/** Triangles that share no vertices; `gap` moves their corners apart. */
function soup(gap = 0) {
  const { points, faces } = ball(8);
  return {
    points: faces.flatMap((face) => face.map((v, k) => points[v].map((x, i) => x + (i === k ? gap : 0)))),
    faces: faces.map((_, f) => [3 * f, 3 * f + 1, 3 * f + 2]),
  };
}

/** Two balls beside each other. */
function pair() {
  const { points, faces } = ball(16);
  return {
    points: [...points, ...points.map(([x, y, z]) => [x + 2.5, y, z])],
    faces: [...faces, ...faces.map((face) => face.map((v) => v + points.length))],
  };
}

const columns = 30, rows = 30;

/** A flat sheet with edges of 1. */
function sheet() {
  const at = (x, y) => y * (columns + 1) + x;
  const points = [], faces = [];
  for (let y = 0; y <= rows; ++y) for (let x = 0; x <= columns; ++x) points.push([x, y, 0]);
  for (let y = 0; y < rows; ++y) {
    for (let x = 0; x < columns; ++x) {
      faces.push([at(x, y), at(x + 1, y), at(x + 1, y + 1)], [at(x, y), at(x + 1, y + 1), at(x, y + 1)]);
    }
  }
  return { points, faces };
}

/** The sheet as a roof: two planes that meet in a crease at y = 15, in the middle. */
function roof() {
  const { points, faces } = sheet();
  return { points: points.map(([x, y]) => [x, y, -0.6 * Math.abs(y - 15)]), faces };
}

/** A point of a drawing on the sheet: the first corner of a face of it. */
export function sheetVertex(x, y) {
  return { face: 2 * (y * columns + x), barycentric: [1, 0, 0] };
}

const kinds = {
  sheet, roof, pair, ball: () => ball(), large: () => ball(400), twice, broken, soup: () => soup(), loose: () => soup(1e-7),
};

/** This mesh as arrays. */
export function arrays(kind) {
  const { points, faces } = kinds[kind]();
  return { positions: new Float64Array(points.flat()), indices: new Uint32Array(faces.flat()) };
}

/** The path of an OFF file with this mesh. */
export function mesh(kind) {
  const { points, faces } = kinds[kind]();
  const path = join(folder, `${kind}.off`);
  const lines = [`OFF`, `${points.length} ${faces.length} 0`, ...points.map((p) => p.join(' ')),
    ...faces.map((f) => `3 ${f.join(' ')}`)];
  writeFileSync(path, `${lines.join('\n')}\n`);
  return path;
}

/** The path of a glTF file with this mesh, whose unit is the metre. */
export function inMetres(kind) {
  const { points, faces } = kinds[kind]();
  const positions = Buffer.from(new Float32Array(points.flat()).buffer), corners = Buffer.from(new Uint32Array(faces.flat()).buffer);
  const path = join(folder, `${kind}.gltf`);
  writeFileSync(path, JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: points.length, type: 'VEC3' },
      { bufferView: 1, componentType: 5125, count: 3 * faces.length, type: 'SCALAR' }],
    bufferViews: [{ buffer: 0, byteOffset: 0, byteLength: positions.length },
      { buffer: 0, byteOffset: positions.length, byteLength: corners.length }],
    buffers: [{ byteLength: positions.length + corners.length,
      uri: `data:application/octet-stream;base64,${Buffer.concat([positions, corners]).toString('base64')}` }],
  }));
  return path;
}

/** The path of a GIFTI file with this mesh, whose unit is the millimetre. */
export function inMillimetres(kind) {
  const { points, faces } = kinds[kind]();
  const array = (intent, type, rows) => `<DataArray Intent="NIFTI_INTENT_${intent}" DataType="NIFTI_TYPE_${type}" `
    + `ArrayIndexingOrder="RowMajorOrder" Dimensionality="2" Dim0="${rows.length}" Dim1="3" Encoding="ASCII" `
    + `Endian="LittleEndian"><Data>${rows.map((row) => row.join(' ')).join('\n')}</Data></DataArray>`;
  const path = join(folder, `${kind}.surf.gii`);
  writeFileSync(path, '<?xml version="1.0"?><GIFTI Version="1.0" NumberOfDataArrays="2">'
    + `${array('POINTSET', 'FLOAT32', points)}${array('TRIANGLE', 'INT32', faces)}</GIFTI>`);
  return path;
}

export function meanEdge(kind) {
  const { points, faces } = kinds[kind]();
  const lengths = faces.flatMap((face) => face.map((v, k) => {
    const [p, q] = [points[v], points[face[(k + 1) % 3]]];
    return Math.hypot(...p.map((x, i) => x - q[i]));
  }));
  return lengths.reduce((sum, length) => sum + length, 0) / lengths.length;
}
