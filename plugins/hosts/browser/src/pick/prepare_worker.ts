// A worker that makes the arrays that show a mesh, and the tree that picks on it.
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { shapeOf, type Shape } from './shape';

export interface PrepareRequest {
  positions: Float32Array;
  triangles: Uint32Array;
}

export interface PrepareAnswer {
  shape: Shape;
  tree: ReturnType<typeof MeshBVH.serialize>;
}

interface WorkerSide {
  onmessage: ((event: MessageEvent<PrepareRequest>) => void) | null;
  postMessage(answer: PrepareAnswer | 'loaded', transfer: Transferable[]): void;
}
const side = self as unknown as WorkerSide;

side.onmessage = (event) => {
  const { positions, triangles } = event.data;
  const shape = shapeOf(positions, triangles);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  // Indirect, so that faces keep their numbers.
  const tree = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }), { cloneBuffers: false });
  // All arrays are transferred: the worker keeps nothing for the next mesh.
  const arrays = [shape.positions, shape.normals, shape.index, tree.indirectBuffer];
  side.postMessage({ shape, tree: { ...tree, index: null } },
    [...arrays.flatMap((array) => (array ? [array.buffer] : [])), ...tree.roots] as Transferable[]);
};
side.postMessage('loaded', []);
