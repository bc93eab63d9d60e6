// Keeps the session while one works, and brings it back.
import { changed, type Store } from '../state/store';
import type { ViewCamera } from '../view/camera';
import { type Desk, sentenceOf } from '../actions/desk';
import { download } from '../actions/files_work';
import type { Live } from '../actions/live';
import type { MeshWork } from '../actions/mesh_work';
import { byId, input, setText } from '../elements';
import { forgetAll, isKeptOnMachine, keep, keepOnMachine, kept } from './keep';
import { sessionOf, sessionText, type Session } from './session';

/** A drawing is kept this long after the last edit, and at once when the page is left. */
const pause = 400;

export class SessionWork {
  private timer = 0;
  private forgotten = false;
  /** A drawing whose mesh did not fit into the tab, until that mesh is opened again. */
  private waiting: Session | null = null;

  constructor(private readonly desk: Desk, private readonly store: Store, private readonly live: Live,
              private readonly meshes: MeshWork, private readonly camera: ViewCamera) {
    input('on-machine').addEventListener('change', () => void this.setOnMachine(input('on-machine').checked));
    store.set({ onMachine: isKeptOnMachine() });
    store.watch((now, before) => {
      if (changed(now, before, 'onMachine')) input('on-machine').checked = now.onMachine;
      if (now === before) return;
      if (now.mesh !== before.mesh) void this.goOn();
      if (changed(now, before, 'drawing', 'mesh', 'show') && now.mesh) this.soon();
    });
    addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.keepNow();
    });
  }

  /** Brings back what was kept; returns whether there was anything. */
  async bringBack(): Promise<boolean> {
    const session = await this.desk.wait('session', 'Bringing back the session', kept());
    if (!session?.mesh) return false;
    if (session.mesh.bytes.length > 0) return this.open(session);
    this.waiting = session;
    this.store.trouble('mesh', `Open ${session.mesh.name} again to go on with the drawing: the mesh is too large `
      + 'for this tab to keep.');
    return false;
  }

  async openFile(file: File): Promise<void> {
    const session = await this.desk.wait('files', `Reading ${file.name}`,
      file.text().then((text) => sessionOf(file.name, text)));
    if (session) await this.open(session);
  }

  async saveFile(): Promise<void> {
    const session = this.session();
    if (!session) return;
    const text = await this.desk.wait('files', 'Writing the session', sessionText(session));
    if (!text) return;
    const name = this.store.now.mesh?.name.replace(/(\.[^.]+)?(\.gz)?$/i, '') ?? 'session';
    download(`${name}.talweg`, new Blob([text], { type: 'application/json' }));
  }

  async forget(): Promise<void> {
    this.forgotten = true;
    clearTimeout(this.timer);
    try {
      await forgetAll();
      location.reload();
    } catch (error) {
      this.forgotten = false;
      this.store.trouble('session', sentenceOf(error));
    }
  }

  private async setOnMachine(on: boolean): Promise<void> {
    try {
      await keepOnMachine(on);
    } catch (error) {
      this.store.trouble('session', sentenceOf(error));
    }
    this.store.set({ onMachine: isKeptOnMachine() });
    await this.keepNow();
  }

  private async open(session: Session): Promise<boolean> {
    const { mesh } = session;
    if (!mesh || !(await this.meshes.open(mesh.name, mesh.bytes, mesh.repaired))) return false;
    this.restore(session);
    return true;
  }

  private restore(session: Session): void {
    try {
      this.desk.editor.restore(session.drawing);
      this.store.set({ show: session.show });
      this.camera.restore(session.camera);
      this.live.refresh();
    } catch (error) {
      this.store.trouble('session', sentenceOf(error));
    }
  }

  /** The mesh that a drawing waits for may have been opened. */
  private async goOn(): Promise<void> {
    const { waiting } = this;
    const { mesh } = this.store.now;
    if (!waiting?.mesh || !mesh || mesh.name !== waiting.mesh.name) return;
    this.waiting = null;
    this.store.trouble('mesh', null);
    if (mesh.repaired !== waiting.mesh.repaired) await this.meshes.repair();
    this.restore(waiting);
  }

  private session(): Session | null {
    const { mesh, show } = this.store.now;
    if (!mesh) return null;
    const { name, repaired, bytes } = mesh;
    return { mesh: { name, repaired, bytes }, drawing: this.desk.editor.state(), camera: this.camera.state(), show };
  }

  private soon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.keepNow(), pause);
  }

  private async keepNow(): Promise<void> {
    const session = this.session();
    if (!session || this.forgotten) return;
    try {
      const whole = await keep(session);
      const where = this.store.now.onMachine ? 'on this device' : 'until this tab is closed';
      setText('kept-told', whole ? `The session is kept ${where}.`
        : `The drawing is kept ${where}; the mesh is too large and would have to be opened again.`);
      byId('kept-told').hidden = false;
      this.store.trouble('session', null);
    } catch (error) {
      this.store.trouble('session', sentenceOf(error));
    }
  }
}
