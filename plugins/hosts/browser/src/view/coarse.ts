// A coarser mesh for the time while the view turns, where drawing the whole one takes too long.
import type { Shape } from '../pick/shape';
import type { CoarseRequest } from './coarse_worker';

/** So many triangles turn smoothly also where no graphics card draws. */
export const coarseFaces = 60_000;

/** Triangles on some vertices of the shape; null where none can be made: the whole mesh is shown then. */
export function coarser({ positions, index }: Shape): Promise<Uint32Array | null> {
  return new Promise((resolve) => {
    const worker = new Worker(new URL('coarse_worker.js', document.baseURI), { type: 'module' });
    const end = (coarse: Uint32Array | null) => {
      worker.terminate();
      resolve(coarse && coarse.length > 0 ? coarse : null);
    };
    worker.onmessage = (event: MessageEvent<Uint32Array>) => end(event.data);
    worker.onerror = () => end(null);
    worker.onmessageerror = () => end(null);
    const request: CoarseRequest = { positions, index, faces: coarseFaces };
    worker.postMessage(request);
  });
}
