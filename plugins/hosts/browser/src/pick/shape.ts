// Arrays that show a mesh with smooth shading and sharp edges. Only corners on sharp edges get
// separate points, which saves memory for a million faces.

export interface Shape {
  positions: Float32Array;
  normals: Float32Array;
  /** The mesh's triangles, in the same order. */
  index: Uint32Array;
}

/** Edges with a larger angle between their faces are shown sharp. */
const sharp = Math.cos((40 * Math.PI) / 180);

/** Unit normals of the faces; zero for faces without area. */
function faceNormals(positions: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(triangles.length);
  for (let f = 0; f < triangles.length; f += 3) {
    const a = 3 * triangles[f], b = 3 * triangles[f + 1], c = 3 * triangles[f + 2];
    const x1 = positions[b] - positions[a], y1 = positions[b + 1] - positions[a + 1];
    const z1 = positions[b + 2] - positions[a + 2];
    const x2 = positions[c] - positions[a], y2 = positions[c + 1] - positions[a + 1];
    const z2 = positions[c + 2] - positions[a + 2];
    const x = y1 * z2 - z1 * y2, y = z1 * x2 - x1 * z2, z = x1 * y2 - y1 * x2;
    const length = Math.hypot(x, y, z) || 1;
    normals[f] = x / length;
    normals[f + 1] = y / length;
    normals[f + 2] = z / length;
  }
  return normals;
}

/** The corners (3 f + k) at each vertex, one after another, and the index at which each vertex's
   corners begin. */
function cornersAtVertices(triangles: Uint32Array, vertices: number) {
  const begin = new Uint32Array(vertices + 1);
  for (const v of triangles) ++begin[v + 1];
  for (let v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
  const next = begin.slice();
  const corners = new Uint32Array(triangles.length);
  for (let c = 0; c < triangles.length; ++c) corners[next[triangles[c]]++] = c;
  return { begin, corners };
}

/** The corners at a vertex in groups, whose faces turn little from the group's first face; mostly
   one group. */
function groupsOf(faces: Float32Array, open: Uint32Array): ArrayLike<number>[] {
  const turnsLittle = (c: number, d: number) => {
    const f = c - (c % 3), g = d - (d % 3);
    return faces[f] * faces[g] + faces[f + 1] * faces[g + 1] + faces[f + 2] * faces[g + 2] >= sharp;
  };
  const groups: ArrayLike<number>[] = [];
  for (let rest: Uint32Array = open; rest.length > 0;) {
    const seed = rest[0];
    const belongs = (c: number) => c === seed || turnsLittle(seed, c);
    if (rest.every(belongs)) return [...groups, rest];
    groups.push(rest.filter(belongs));
    rest = rest.filter((c) => !belongs(c));
  }
  return groups;
}

function meanNormal(faces: Float32Array, group: ArrayLike<number>): [number, number, number] {
  let x = 0, y = 0, z = 0;
  for (let k = 0; k < group.length; ++k) {
    const f = group[k] - (group[k] % 3);
    x += faces[f];
    y += faces[f + 1];
    z += faces[f + 2];
  }
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}

/** Each corner's normal is the mean over those faces at its vertex that turn little from the
   corner's own face. */
export function shapeOf(positions: Float32Array, triangles: Uint32Array): Shape {
  const vertices = positions.length / 3;
  const faces = faceNormals(positions, triangles);
  const { begin, corners } = cornersAtVertices(triangles, vertices);
  const normals = new Float32Array(positions.length);
  const index = triangles.slice();
  const more: number[] = [], moreNormals: number[] = [];
  for (let v = 0; v < vertices; ++v) {
    groupsOf(faces, corners.subarray(begin[v], begin[v + 1])).forEach((group, k) => {
      const normal = meanNormal(faces, group);
      if (k === 0) {
        normals.set(normal, 3 * v);
        return;
      }
      const id = vertices + more.length / 3;
      more.push(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
      moreNormals.push(...normal);
      for (let c = 0; c < group.length; ++c) index[group[c]] = id;
    });
  }
  return { positions: joined(positions, more), normals: joined(normals, moreNormals), index };
}

function joined(first: Float32Array, more: number[]): Float32Array {
  const result = new Float32Array(first.length + more.length);
  result.set(first);
  result.set(more, first.length);
  return result;
}
