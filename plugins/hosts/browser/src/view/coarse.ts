// A coarser mesh for the time while the view turns, where drawing the whole one takes too long.
import type { Shape } from '../pick/shape';
import type { CoarseRequest } from './coarse_worker';

/** So long a frame may take while the view turns, ms. */
const frame = 30;
/** Fewer triangles show no shape, and more are not worth it. */
const least = 8_000, most = 200_000;

/** So many triangles are drawn in time where all of a mesh take `took` ms; null: as many as it has, or nearly. */
export function coarseFaces(faces: number, took: number): number | null {
  const wanted = Math.min(most, Math.max(least, Math.round((faces * frame) / took)));
  return wanted < faces / 2 ? wanted : null;
}

/** Triangles on some vertices of the shape, about so many; null where none can be made: the whole mesh is shown then. */
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
