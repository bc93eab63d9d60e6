// Finds the place of the mesh under the mouse, by a tree of boxes that a worker has made.
import { DoubleSide, Ray, Vector3 } from 'three';
import type { MeshBVH } from 'three-mesh-bvh';
import type { MeshInfo, Vec3 } from '../engine/types';
import type { Place } from '../state/state';
import { barycentricOf, corners, positionOf } from '../view/vectors';

export class Picker {
  constructor(private readonly mesh: MeshInfo, private readonly tree: MeshBVH) {}

  /** The first place of the mesh along a ray; null if the ray meets none. */
  first(ray: Ray): Place | null {
    const hit = this.tree.raycastFirst(ray, DoubleSide);
    if (!hit || hit.faceIndex === null || hit.faceIndex === undefined) return null;
    const barycentric = barycentricOf(this.mesh, hit.faceIndex, hit.point.toArray() as Vec3);
    const place = { face: hit.faceIndex, barycentric };
    return { ...place, position: positionOf(this.mesh, place) };
  }

  /** Whether the mesh lies between the eye and a position on it. */
  isHidden(position: Vec3, eye: Vector3): boolean {
    const way = new Vector3(...position).sub(eye);
    const distance = way.length();
    const hit = this.tree.raycastFirst(new Ray(eye.clone(), way.normalize()), DoubleSide);
    // Curves lie in the faces: a hit so close to the position is the position itself.
    return !!hit && hit.distance < distance - 1e-3 * this.mesh.size;
  }

  /** The normal of the face nearest to a position. */
  normalNear(position: Vec3): Vector3 | null {
    const found = this.tree.closestPointToPoint(new Vector3(...position));
    if (!found) return null;
    const [a, b, c] = corners(this.mesh, found.faceIndex).map((corner) => new Vector3(...corner));
    return b.sub(a).cross(c.sub(a)).normalize();
  }
}
