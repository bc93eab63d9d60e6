// Makes the arrays that show a mesh and the tree that finds places on it, in a worker that is
// loaded at the start, so that a page without a network can still open meshes.
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { Ended } from '../engine/engine';
import type { MeshInfo } from '../engine/types';
import { Picker } from './picker';
import type { PrepareAnswer, PrepareRequest } from './prepare_worker';
import type { Shape } from './shape';

export interface Prepared {
  shape: Shape;
  picker: Picker;
}

export class Preparer {
  private worker = newWorker();
  /** Rejects the running preparation. */
  private stop: ((reason: Error) => void) | null = null;

  /** Resolves when everything is loaded. Throws Error with a sentence. */
  async loaded(): Promise<void> {
    await this.worker;
  }

  /** One mesh at a time. Throws Error with a sentence. */
  async prepare(mesh: MeshInfo): Promise<Prepared> {
    try {
      const { shape, tree } = await this.ask({ positions: mesh.positions, triangles: mesh.triangles });
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
      geometry.setIndex(new BufferAttribute(mesh.triangles, 1));
      return { shape, picker: new Picker(mesh, MeshBVH.deserialize(tree, geometry, { setIndex: false })) };
    } catch (error) {
      this.renew();
      throw error;
    } finally {
      this.stop = null;
    }
  }

  /** Ends the running preparation, which rejects with Ended. */
  end(): void {
    this.stop?.(new Ended('The preparation was ended.'));
  }

  private ask(request: PrepareRequest): Promise<PrepareAnswer> {
    return new Promise((resolve, reject) => {
      this.stop = reject;
      this.worker.then((worker) => {
        worker.onmessage = (event: MessageEvent<PrepareAnswer>) => resolve(event.data);
        worker.onerror = (event) => reject(failure('has too little memory', event));
        worker.postMessage(request);
      }, reject);
    });
  }

  private renew(): void {
    this.worker.then((worker) => worker.terminate(), () => {});
    this.worker = newWorker();
  }
}

/** The worker's first message says that it is loaded. */
function newWorker(): Promise<Worker> {
  const loaded = new Promise<Worker>((resolve, reject) => {
    const worker = new Worker(new URL('prepare_worker.js', document.baseURI), { type: 'module' });
    worker.onmessage = () => resolve(worker);
    worker.onerror = (event) => reject(failure('cannot be loaded', event));
  });
  loaded.catch(() => {});  // the error is reported to callers of loaded()
  return loaded;
}

function failure(what: string, { message }: ErrorEvent): Error {
  return new Error(`The view of the mesh cannot be made: its worker ${what}${message ? ` (${message})` : ''}.`);
}
