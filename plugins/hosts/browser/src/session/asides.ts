// Drawings on other meshes are put aside when another mesh is opened, and can be brought back.
import { type Desk, type Openings, sentenceOf } from '../actions/desk';
import type { MeshWork } from '../actions/mesh_work';
import type { Editor } from '../engine/editor';
import type { Drawing } from '../engine/types';
import type { OpenMesh } from '../state/state';
import type { Current } from './current';
import { keepAsides } from './keep';
import type { Session } from './session';

export interface Aside {
  /** Unique among the drawings that were put aside. */
  id: number;
  /** The session's mesh has no bytes if they were too many to be kept; the user must open the file
     then. */
  session: Session;
  curves: number;
  /** The editor with the drawing's history, until the page is left. */
  editor: Editor | null;
}

/** Limits: the number of kept drawings, and the bytes of the newest ones' meshes in total. */
const most = 5, roomOfMeshes = 300e6;

export class Asides implements Openings {
  private ids = 0;
  /** The drawing that the opening of the present mesh put aside. */
  private behind: Aside | null = null;
  /** The drawing that was open before an opening was undone. */
  private ahead: Aside | null = null;

  constructor(private readonly desk: Desk, private readonly current: Current,
              private readonly meshes: MeshWork) {
    desk.openings = this;
    meshes.beforeAnother = () => this.putAside();
    desk.store.watch((now, before) => {
      if (now.mesh && now.mesh.id !== before.mesh?.id && !current.opening) void this.meet(now.mesh);
      if (now.asides !== before.asides) this.keep();
    });
  }

  /** Puts kept sessions aside. Equal sessions are kept once, empty ones not at all. */
  add(sessions: Session[]): void {
    const known = this.list.map(({ session }) => session.drawing);
    const more = sessions.filter(({ drawing }) => !known.includes(drawing)).map((session) => this.asideOf(session, null));
    if (more.length > 0) this.set([...this.list, ...more]);
  }

  /** After a reload: Undo restores the drawing that the present mesh replaced, if nothing is drawn
     on it yet. */
  standBehind(): void {
    const [newest] = this.list;
    const { drawing } = this.desk.store.now;
    if (newest?.session.mesh?.bytes.length && drawing.curves.length === 0) this.place(newest, null);
  }

  async bringBack(id: number): Promise<void> {
    const aside = this.list.find((one) => one.id === id);
    if (aside) await this.take(aside);
  }

  undoName(): string | null {
    return this.behind ? `Open ${this.desk.store.now.mesh?.name ?? ''}` : null;
  }

  redoName(): string | null {
    return this.ahead ? `Open ${this.ahead.session.mesh?.name ?? ''}` : null;
  }

  undo(): void {
    const { behind } = this;
    if (behind) void this.take(behind).then((left) => left && this.place(null, left));
  }

  redo(): void {
    const { ahead } = this;
    if (ahead) void this.take(ahead);
  }

  forgetRedo(): void {
    if (this.ahead) this.place(this.behind, null);
  }

  private get list(): Aside[] {
    return this.desk.store.now.asides;
  }

  private set(all: Aside[]): void {
    let room = roomOfMeshes;
    this.desk.store.set({
      asides: all.filter(({ curves }) => curves > 0).slice(0, most).map((aside) => {
        room -= aside.session.mesh?.bytes.length ?? 0;
        return room >= 0 ? aside : withoutMesh(aside);
      }),
    });
  }

  private asideOf(session: Session, editor: Editor | null): Aside {
    const { curves } = JSON.parse(session.drawing) as Drawing;
    return { id: ++this.ids, session, curves: curves.length, editor };
  }

  private putAside(): void {
    const session = this.current.session();
    const aside = session && this.asideOf(session, this.desk.editor);
    const has = aside && aside.curves > 0;
    this.place(has ? aside : null, null);
    if (has) this.set([aside, ...this.list]);
  }

  private place(behind: Aside | null, ahead: Aside | null): void {
    this.behind = behind;
    this.ahead = ahead;
    this.desk.store.set({ undo: this.desk.editor.undoName() ?? this.undoName(),
      redo: this.desk.editor.redoName() ?? this.redoName() });
  }

  /** Opens it again, and puts the open drawing aside, which is returned. */
  private async take(aside: Aside): Promise<Aside | null> {
    const { mesh } = aside.session;
    if (this.desk.store.now.opening) return null;
    if (!mesh || mesh.bytes.length === 0) {
      this.desk.store.trouble('mesh', `Open ${mesh?.name ?? 'its mesh'} again to go on with the drawing.`);
      return null;
    }
    const session = this.current.session();
    const left = session && this.asideOf(session, this.desk.editor);
    if (!(await this.current.open(aside.session, aside.editor))) return null;
    this.set(this.list.filter((one) => one !== aside));
    this.desk.tell(`The drawing on ${mesh.name} is back.`);
    return this.behind ?? left;
  }

  /** The opened mesh may be the one that a drawing waits for. */
  private async meet({ name, repaired, info }: OpenMesh): Promise<void> {
    const waiting = this.list.find(({ session: { mesh } }) => mesh !== null && mesh.bytes.length === 0
      && mesh.name === name && (mesh.faces === undefined || mesh.faces === info.faces));
    if (!waiting) return;
    this.set(this.list.filter((one) => one !== waiting));
    if (waiting.session.mesh?.repaired && !repaired) await this.meshes.repair(waiting.session.mesh.weld);
    if (waiting.session.mesh?.unit) await this.meshes.setUnit(waiting.session.mesh.unit);
    this.current.restore(waiting.session, waiting.editor);
  }

  private keep(): void {
    try {
      keepAsides(this.list.map(({ session }) => session)).catch((error: unknown) => this.failed(error));
    } catch (error) {
      this.failed(error);
    }
  }

  private failed(error: unknown): void {
    this.desk.store.trouble('session', sentenceOf(error));
  }
}

function withoutMesh(aside: Aside): Aside {
  const { mesh } = aside.session;
  return mesh ? { ...aside, session: { ...aside.session, mesh: { ...mesh, bytes: new Uint8Array() } } } : aside;
}
