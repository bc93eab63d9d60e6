// The connected parts of a mesh: a curve cannot leave its part.
import type { MeshInfo } from '../engine/types';

/** For each vertex a representative of its part. */
const found = new WeakMap<MeshInfo, Uint32Array>();

/** Whether a curve can lead from one face to another. For a repaired mesh the answer is yes, since
   a repair may have joined parts. */
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
