// Opens meshes: from a file, the sample, with repair, and again in a new engine.
import type { MeshInfo } from '../engine/types';
import { Editor } from '../engine/editor';
import { Picker } from '../pick/picker';
import type { Shape } from '../pick/shape';
import { countText } from '../state/numbers';
import type { OpenMesh } from '../state/state';
import type { Desk } from './desk';
import { type Live, smoothingWords } from './live';

export class MeshWork {
  /** Finds places on the mesh; null until the mesh is prepared. */
  picker: Picker | null = null;
  /** Whether all about the mesh is shown. */
  wantsAll = false;
  private ids = 0;

  constructor(private readonly desk: Desk, private readonly live: Live,
              private readonly showShape: (shape: Shape | null) => void,
              private readonly lookAtIt: () => void) {}

  async openFile(file: File): Promise<boolean> {
    const bytes = new Uint8Array(await file.arrayBuffer());
    return this.open(file.name, bytes, false);
  }

  async openSample(): Promise<boolean> {
    const sample = await this.desk.wait('mesh', 'Making the sample', this.desk.engine.sample());
    return sample ? this.open(sample.name, sample.bytes, false) : false;
  }

  /** Opens the mesh once more, mended. The drawing, if any, is of no face numbers that stay: it goes. */
  async repair(): Promise<boolean> {
    const mesh = this.desk.store.now.mesh;
    return mesh ? this.open(mesh.name, mesh.bytes, true) : false;
  }

  /** Opens a mesh and begins a new drawing. The mesh that was there stays where this one fails. */
  async open(name: string, bytes: Uint8Array, repaired: boolean): Promise<boolean> {
    const { desk } = this;
    const info = await desk.wait('mesh', `Opening ${name}`, this.read(name, bytes, repaired));
    if (!info) {
      await this.reopen();
      return false;
    }
    desk.editor = await Editor.load();
    this.live.reset();
    await this.show({ id: ++this.ids, name, bytes, repaired, info });
    return true;
  }

  /** Ends work that takes too long: a new engine gets the mesh again, and the drawing stays. */
  async endWork(): Promise<void> {
    const smoothing = this.desk.store.now.busy?.what === smoothingWords;
    await this.desk.endEngine();
    this.desk.tell('Ended.');
    await this.reopen();
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

  private async show(mesh: OpenMesh): Promise<void> {
    const { desk } = this;
    this.picker = null;
    desk.store.set({ mesh, words: null });
    const picker = await desk.wait('mesh', 'Preparing the view', Picker.prepare(mesh.info, (shape) => {
      if (desk.store.now.mesh !== mesh) return;
      this.showShape(shape);
      this.lookAtIt();
    }));
    if (desk.store.now.mesh !== mesh || !picker) return;
    this.picker = picker;
    void this.tellAll();
    desk.tell(`${mesh.name}: ${countText(mesh.info.faces)} faces. ${mesh.info.defects ?? 'Draw on it.'}`);
  }
}
