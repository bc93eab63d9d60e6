// Returns the open session as a value, and opens another one.
import type { Desk } from '../actions/desk';
import { sentenceOf } from '../actions/desk';
import type { Live } from '../actions/live';
import type { MeshWork } from '../actions/mesh_work';
import type { Editor } from '../engine/editor';
import { firstState } from '../state/state';
import type { ViewCamera } from '../view/camera';
import type { Session } from './session';

export class Current {
  /** A session is being opened; its drawing follows when its mesh is open. */
  opening = false;

  constructor(private readonly desk: Desk, private readonly live: Live, private readonly meshes: MeshWork,
              private readonly camera: ViewCamera) {}

  session(): Session | null {
    const { mesh, show } = this.desk.store.now;
    if (!mesh) return null;
    const { name, repaired, weld, unit, bytes, info: { faces } } = mesh;
    return {
      mesh: { name, repaired, weld, unit, bytes, faces }, drawing: this.desk.editor.state(),
      camera: this.camera.state(), show,
    };
  }

  /** Opens a session; `editor` has its drawing's history, if still known. */
  async open(session: Session, editor: Editor | null = null): Promise<boolean> {
    const { mesh } = session;
    this.opening = true;
    try {
      if (!mesh || !(await this.meshes.open(mesh.name, mesh.bytes, mesh))) return false;
    } finally {
      this.opening = false;
    }
    this.restore(session, editor);
    return true;
  }

  /** Restores a session's drawing on the open mesh. */
  restore(session: Session, editor: Editor | null = null): void {
    const { desk } = this;
    try {
      if (editor) desk.editor = editor;
      else desk.editor.restore(session.drawing);
      desk.store.set({ show: { ...firstState.show, ...session.show } });
      this.camera.restore(session.camera);
      this.live.refresh();
    } catch (error) {
      desk.store.trouble('session', sentenceOf(error));
    }
  }
}
