// Vectors of three numbers, and points of faces from barycentric coordinates.
import type { MeshInfo, Vec3 } from '../engine/types';

export function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function at(values: ArrayLike<number>, index: number): Vec3 {
  return [values[3 * index], values[3 * index + 1], values[3 * index + 2]];
}

export function corners(mesh: MeshInfo, face: number): [Vec3, Vec3, Vec3] {
  const [a, b, c] = at(mesh.triangles, face);
  return [at(mesh.positions, a), at(mesh.positions, b), at(mesh.positions, c)];
}

export function positionOf(mesh: MeshInfo, p: { face: number; barycentric: Vec3 }): Vec3 {
  const [a, b, c] = corners(mesh, p.face);
  const [u, v, w] = p.barycentric;
  return [0, 1, 2].map((k) => u * a[k] + v * b[k] + w * c[k]) as Vec3;
}

/** The barycentric coordinates of a position in the plane of a face, moved into the face. */
export function barycentricOf(mesh: MeshInfo, face: number, position: Vec3): Vec3 {
  const [a, b, c] = corners(mesh, face);
  const ab = minus(b, a), ac = minus(c, a), ap = minus(position, a);
  const bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
  const pb = dot(ap, ab), pc = dot(ap, ac);
  const area = bb * cc - bc * bc;
  // In a face without area every point is the first corner.
  if (!(area > 0)) return [1, 0, 0];
  const v = Math.max(0, (cc * pb - bc * pc) / area);
  const w = Math.max(0, (bb * pc - bc * pb) / area);
  const u = Math.max(0, 1 - v - w);
  const sum = u + v + w;
  return [u / sum, v / sum, w / sum];
}
