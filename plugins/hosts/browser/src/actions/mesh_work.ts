// Opens meshes: from a file, the sample, with repair, and again in a new engine.
import type { MeshInfo } from '../engine/types';
import { Editor } from '../engine/editor';
import type { Picker } from '../pick/picker';
import { type Prepared, Preparer } from '../pick/preparer';
import type { Shape } from '../pick/shape';
import { countText } from '../state/numbers';
import { type Desk, sentenceOf } from './desk';
import { type Live, smoothingWords } from './live';

export class MeshWork {
  /** Finds places on the mesh; null until there is one. */
  picker: Picker | null = null;
  /** Whether all about the mesh is shown. */
  wantsAll = false;
  /** Called when another mesh is ready, before it takes the place of the one that is open. */
  beforeAnother: () => void = () => {};
  private readonly preparer = new Preparer();
  private turn: Promise<unknown> = Promise.resolve();
  private ending = false;
  private ids = 0;

  constructor(private readonly desk: Desk, private readonly live: Live,
              private readonly showShape: (shape: Shape | null) => void,
              private readonly lookAtIt: () => void) {}

  /** Resolves as soon as meshes can be opened without a net. Throws Error with a sentence. */
  loaded(): Promise<void> {
    return this.preparer.loaded();
  }

  async openFile(file: File): Promise<boolean> {
    const bytes = await this.desk.wait('mesh', `Reading ${file.name}`, bytesOf(file));
    return bytes ? this.open(file.name, bytes, false) : false;
  }

  async openSample(): Promise<boolean> {
    const sample = await this.desk.wait('mesh', 'Making the sample', this.desk.engine.sample());
    return sample ? this.open(sample.name, sample.bytes, false) : false;
  }

  /** Opens the mesh once more, mended. The drawing, if any, is of no face numbers that stay: it is put aside. */
  async repair(): Promise<boolean> {
    const mesh = this.desk.store.now.mesh;
    return mesh ? this.open(mesh.name, mesh.bytes, true) : false;
  }

  /**
   * Opens a mesh and begins a new drawing. Until everything of it is ready, the mesh that was there
   * stays, and so it does where this one fails.
   */
  open(name: string, bytes: Uint8Array, repaired: boolean): Promise<boolean> {
    const mine = this.turn.then(() => this.openNow(name, bytes, repaired));
    this.turn = mine.catch(() => {});
    return mine;
  }

  /** Ends work that takes too long: a new engine gets the mesh again, and the drawing stays. */
  async endWork(): Promise<void> {
    if (this.ending) return;
    const smoothing = this.desk.store.now.busy?.what === smoothingWords;
    this.ending = true;
    try {
      await this.desk.endEngine();
      this.preparer.end();
      this.desk.tell('Ended.');
      await this.reopen();
    } catch (error) {
      this.desk.store.trouble('mesh', `What runs could not be ended: ${sentenceOf(error)}`);
      return;
    } finally {
      this.ending = false;
    }
    // The new engine knows the curves again, unless just that took too long.
    if (!smoothing) this.live.refresh();
  }

  /** Tells all about the mesh, if a person wants to know it. */
  async tellAll(): Promise<void> {
    const { store, engine } = this.desk;
    const { mesh, words } = store.now;
    if (!mesh || words !== null || !this.wantsAll) return;
    const told = await this.desk.wait('mesh', 'Looking at the mesh', engine.words());
    if (told !== undefined && store.now.mesh === mesh) store.set({ words: told });
  }

  private async openNow(name: string, bytes: Uint8Array, repaired: boolean): Promise<boolean> {
    const { desk } = this;
    desk.store.set({ opening: true });
    try {
      const ready = await this.ready(name, bytes, repaired);
      if (!ready) {
        if (!this.ending) await this.reopen();
        return false;
      }
      const editor = await Editor.load();
      this.beforeAnother();
      desk.editor = editor;
      desk.store.set({ mesh: { id: ++this.ids, name, bytes, repaired, info: ready.info }, words: null });
      this.live.reset();
      this.picker = ready.picker;
      this.showShape(ready.shape);
      this.lookAtIt();
      void this.tellAll();
      desk.tell(`${name}: ${countText(ready.info.faces)} faces. ${ready.info.defects ?? 'Draw on it.'}`);
      return true;
    } finally {
      desk.store.set({ opening: false });
    }
  }

  /** All that a mesh needs to be seen and drawn on; null if it failed or was ended. */
  private async ready(name: string, bytes: Uint8Array, repaired: boolean):
    Promise<Prepared & { info: MeshInfo } | null> {
    const info = await this.desk.wait('mesh', `Opening ${name}`, this.read(name, bytes, repaired));
    if (!info || this.ending) return null;
    const prepared = await this.desk.wait('mesh', 'Preparing the view', this.preparer.prepare(info));
    return prepared && !this.ending ? { info, ...prepared } : null;
  }

  private read(name: string, bytes: Uint8Array, repaired: boolean): Promise<MeshInfo> {
    return this.desk.engine.open(name, bytes.slice().buffer, repaired);
  }

  private async reopen(): Promise<void> {
    const mesh = this.desk.store.now.mesh;
    if (!mesh) return;
    // What went wrong before stays told.
    const trouble = this.desk.store.now.trouble.mesh ?? null;
    await this.desk.wait('mesh', `Opening ${mesh.name}`, this.read(mesh.name, mesh.bytes, mesh.repaired));
    if (trouble) this.desk.store.trouble('mesh', trouble);
  }
}

async function bytesOf(file: File): Promise<Uint8Array> {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch {
    throw new Error(`The browser cannot read ${file.name}: is it there still, and smaller than 2 GB?`);
  }
}
