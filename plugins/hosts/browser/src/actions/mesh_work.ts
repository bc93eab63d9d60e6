// Opens meshes: from a file, the sample, repaired, and again in a new engine.
import type { MeshInfo } from '../engine/types';
import { Editor } from '../engine/editor';
import type { Picker } from '../pick/picker';
import { type Prepared, Preparer } from '../pick/preparer';
import { countText } from '../state/numbers';
import type { Opening } from '../state/state';
import { unitName } from '../state/units';
import { type Desk, sentenceOf } from './desk';
import { type Live, smoothingWords } from './live';

export class MeshWork {
  /** Finds places on the mesh; null before the first mesh. */
  picker: Picker | null = null;
  /** Whether the full description of the mesh is shown. */
  wantsAll = false;
  /** Called when another mesh is ready, before it replaces the open one. */
  beforeAnother: () => void = () => {};
  private readonly preparer = new Preparer();
  private turn: Promise<unknown> = Promise.resolve();
  private ending = false;
  private ids = 0;

  constructor(private readonly desk: Desk, private readonly live: Live,
              private readonly show: (ready: Prepared) => void,
              private readonly lookAtIt: () => void) {}

  /** Resolves when meshes can be opened without a network. Throws Error with a sentence. */
  loaded(): Promise<void> {
    return this.preparer.loaded();
  }

  async openFile(file: File): Promise<boolean> {
    const bytes = await this.desk.wait('mesh', `Reading ${file.name}`, bytesOf(file));
    return bytes ? this.open(file.name, bytes, { repaired: false }) : false;
  }

  async openSample(): Promise<boolean> {
    const sample = await this.desk.wait('mesh', 'Making the sample', this.desk.engine.sample());
    return sample ? this.open(sample.name, sample.bytes, { repaired: false }) : false;
  }

  /** Opens the mesh again, repaired. A drawing is put aside, since its face numbers are no longer
     valid. */
  async repair(weld: number | null = null): Promise<boolean> {
    const mesh = this.desk.store.now.mesh;
    return mesh ? this.open(mesh.name, mesh.bytes, { repaired: true, weld, unit: mesh.unit }) : false;
  }

  /** Sets the unit of the mesh's lengths, a UCUM code; empty: the unit of its file. Coordinates do
     not change. */
  async setUnit(unit: string): Promise<void> {
    const { store, engine } = this.desk;
    const { mesh } = store.now;
    if (!mesh) return;
    const done = await this.desk.wait('mesh', 'Setting the unit', engine.setUnit(unit).then(() => true));
    if (!done || store.now.mesh !== mesh) return;
    store.set({ mesh: { ...mesh, unit } });
    this.desk.tell(unit ? `Lengths are in ${unitName(unit)}.` : 'The unit is that of the file.');
  }

  /**
   * Opens a mesh and begins a new drawing. The earlier mesh stays until the new one is ready, and
   * also if the new one fails.
   */
  open(name: string, bytes: Uint8Array, opening: Opening): Promise<boolean> {
    const mine = this.turn.then(() => this.openNow(name, bytes, opening));
    this.turn = mine.catch(() => {});
    return mine;
  }

  /** Ends work that takes too long: a new engine opens the mesh again, and the drawing stays. */
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
      this.desk.store.trouble('mesh', `The running computations could not be stopped: ${sentenceOf(error)}`);
      return;
    } finally {
      this.ending = false;
    }
    // The new engine smooths the curves again, unless smoothing was the work that took too long.
    if (!smoothing) this.live.refresh();
  }

  /** Shows the full description of the mesh, if the user wants it. */
  async tellAll(): Promise<void> {
    const { store, engine } = this.desk;
    const { mesh, words } = store.now;
    if (!mesh || words !== null || !this.wantsAll) return;
    const told = await this.desk.wait('mesh', 'Looking at the mesh', engine.words());
    if (told !== undefined && store.now.mesh === mesh) store.set({ words: told });
  }

  private async openNow(name: string, bytes: Uint8Array, { repaired, weld, unit }: Opening): Promise<boolean> {
    const { desk } = this;
    desk.store.set({ opening: true });
    try {
      const ready = await this.ready(name, bytes, { repaired, weld, unit });
      if (!ready) {
        if (!this.ending) await this.reopen();
        return false;
      }
      const editor = await Editor.load();
      this.beforeAnother();
      desk.editor = editor;
      desk.store.set({ mesh: { id: ++this.ids, name, bytes, repaired, weld, unit, info: ready.info }, words: null });
      this.live.reset();
      this.picker = ready.picker;
      this.show(ready);
      this.lookAtIt();
      void this.tellAll();
      desk.tell(`${name}: ${countText(ready.info.faces)} faces. ${ready.info.defects ?? 'Draw on it.'}`);
      return true;
    } finally {
      desk.store.set({ opening: false });
    }
  }

  /** Everything that is needed to show a mesh and to draw on it; null if opening failed or was
     ended. */
  private async ready(name: string, bytes: Uint8Array, opening: Opening):
    Promise<Prepared & { info: MeshInfo } | null> {
    const info = await this.desk.wait('mesh', `Opening ${name}`, this.read(name, bytes, opening));
    if (!info || this.ending) return null;
    const prepared = await this.desk.wait('mesh', 'Preparing the view', this.preparer.prepare(info));
    return prepared && !this.ending ? { info, ...prepared } : null;
  }

  private async read(name: string, bytes: Uint8Array, { repaired, weld, unit }: Opening): Promise<MeshInfo> {
    const { engine } = this.desk;
    const info = await engine.open(name, bytes.slice().buffer, repaired, weld ?? null);
    if (unit) await engine.setUnit(unit);
    return info;
  }

  private async reopen(): Promise<void> {
    const mesh = this.desk.store.now.mesh;
    if (!mesh) return;
    // The sentence of the earlier error stays.
    const trouble = this.desk.store.now.trouble.mesh ?? null;
    await this.desk.wait('mesh', `Opening ${mesh.name}`, this.read(mesh.name, mesh.bytes, mesh));
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
