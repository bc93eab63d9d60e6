// The desk owns the engine, with the mesh, and the editor, with the drawing. The user's commands
// come here, and their results go into the store.
import { Editor } from '../engine/editor';
import { Ended, Engine, Replaced } from '../engine/engine';
import type { Spot } from '../state/state';
import type { Store } from '../state/store';

/** Openings of meshes, as steps of undo before the first step of the drawing. */
export interface Openings {
  /** null: there is no such step. */
  undoName(): string | null;
  redoName(): string | null;
  undo(): void;
  redo(): void;
  /** The drawing has changed, so an undone opening cannot be redone. */
  forgetRedo(): void;
}

export class Desk {
  openings: Openings | null = null;
  private works = 0;

  private constructor(readonly store: Store, public engine: Engine, public editor: Editor) {}

  static async start(store: Store): Promise<Desk> {
    const [engine, editor] = await Promise.all([Engine.start(), Editor.load()]);
    return new Desk(store, engine, editor);
  }

  /**
   * Waits for work that may take long, shows its name, and puts the sentence of an error beside
   * `spot`. Returns undefined if the work failed, or was replaced or ended.
   */
  async wait<T>(spot: Spot, what: string, work: Promise<T>): Promise<T | undefined> {
    const mine = ++this.works;
    this.store.set({ busy: { what, since: performance.now() } });
    try {
      const result = await work;
      this.store.trouble(spot, null);
      return result;
    } catch (error) {
      if (!isGone(error)) this.store.trouble(spot, sentenceOf(error));
      return undefined;
    } finally {
      if (mine === this.works) this.store.set({ busy: null });
    }
  }

  /**
   * Ends running work at once. The mesh must be opened again afterwards. Throws Error, and ends
   * nothing, if no new engine can be started.
   */
  async endEngine(): Promise<void> {
    const next = await Engine.start();
    const old = this.engine;
    this.engine = next;
    ++this.works;
    this.store.set({ busy: null });
    old.end();
  }

  tell(sentence: string): void {
    this.store.set({ told: sentence });
  }
}

/** Whether the error means that the work was replaced or ended, so that its result is not needed. */
export function isGone(error: unknown): boolean {
  return error instanceof Replaced || error instanceof Ended;
}

export function sentenceOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
