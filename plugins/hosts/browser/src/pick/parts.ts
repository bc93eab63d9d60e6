// The parts of a mesh: no curve gets from one to another.
import type { MeshInfo } from '../engine/types';

/** Of each vertex a vertex of its part, always the same one. */
const found = new WeakMap<MeshInfo, Uint32Array>();

/** Whether a curve can get from one face to another. A repair may have joined parts: then it is taken to. */
export function areJoined(mesh: MeshInfo, face: number, other: number): boolean {
  if (mesh.repaired) return true;
  let parts = found.get(mesh);
  if (!parts) found.set(mesh, (parts = partsOf(mesh)));
  return parts[mesh.triangles[3 * face]] === parts[mesh.triangles[3 * other]];
}

function partsOf({ positions, triangles }: MeshInfo): Uint32Array {
  const above = Uint32Array.from({ length: positions.length / 3 }, (_, v) => v);
  const top = (v: number) => {
    while (above[v] !== v) v = above[v] = above[above[v]];
    return v;
  };
  for (let c = 0; c < triangles.length; c += 3) {
    const a = top(triangles[c]);
    above[top(triangles[c + 1])] = a;
    above[top(triangles[c + 2])] = a;
  }
  for (let v = 0; v < above.length; ++v) above[v] = top(v);
  return above;
}
