// A worker that makes a coarser mesh on a subset of the vertices, for the time while the view
// turns.
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';

export interface CoarseRequest {
  positions: Float32Array;
  index: Uint32Array;
  /** The approximate number of triangles. */
  faces: number;
}

interface WorkerSide {
  onmessage: ((event: MessageEvent<CoarseRequest>) => void) | null;
  postMessage(index: Uint32Array, transfer: Transferable[]): void;
}
const side = self as unknown as WorkerSide;

side.onmessage = async ({ data: { positions, index, faces } }) => {
  await MeshoptSimplifier.ready;
  const [coarse] = MeshoptSimplifier.simplifySloppy(index, positions, 3, null, 3 * faces, 1);
  side.postMessage(coarse, [coarse.buffer as ArrayBuffer]);
};
