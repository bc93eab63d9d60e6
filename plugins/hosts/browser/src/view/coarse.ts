// A coarser mesh for the time while the view turns, if drawing the whole mesh takes too long.
import type { Shape } from '../pick/shape';
import type { CoarseRequest } from './coarse_worker';

/** Time for a frame while the view turns, ms. */
const frame = 30;
/** Triangles: fewer show no shape, and more add nothing visible. */
const least = 8_000, most = 200_000;

/** The number of triangles that can be drawn in time if the whole mesh takes `took` ms; null: all,
   or nearly all. */
export function coarseFaces(faces: number, took: number): number | null {
  const wanted = Math.min(most, Math.max(least, Math.round((faces * frame) / took)));
  return wanted < faces / 2 ? wanted : null;
}

/** About this many triangles on a subset of the shape's vertices; null if there are none: the whole
   mesh is shown then. */
export function coarser({ positions, index }: Shape, faces: number): Promise<Uint32Array | null> {
  return new Promise((resolve) => {
    const worker = new Worker(new URL('coarse_worker.js', document.baseURI), { type: 'module' });
    const end = (coarse: Uint32Array | null) => {
      worker.terminate();
      resolve(coarse && coarse.length > 0 ? coarse : null);
    };
    worker.onmessage = (event: MessageEvent<Uint32Array>) => end(event.data);
    worker.onerror = () => end(null);
    worker.onmessageerror = () => end(null);
    const request: CoarseRequest = { positions, index, faces };
    worker.postMessage(request);
  });
}
