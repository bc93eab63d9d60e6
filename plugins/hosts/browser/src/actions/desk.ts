// The desk has the engine, which knows the mesh, and the editor, which has the drawing. Whatever a
// person does comes here, and what comes of it goes into the store.
import { Editor } from '../engine/editor';
import { Ended, Engine, Replaced } from '../engine/engine';
import type { Spot } from '../state/state';
import type { Store } from '../state/store';

/** Openings of meshes: steps that are undone after those of the drawing. */
export interface Openings {
  /** null: there is no such step. */
  undoName(): string | null;
  redoName(): string | null;
  undo(): void;
  redo(): void;
  /** The drawing has changed: an opening that was undone is not done again. */
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
   * Waits for work that may take long, tells what it is, and puts the sentence of a failure beside
   * `spot`. Gives undefined where it failed, or was replaced or ended.
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
   * Ends what runs, however long it would take. The mesh has to be opened again. Throws Error, and
   * ends nothing, where no new engine can be had.
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

/** Whether nobody waits for this any more. */
export function isGone(error: unknown): boolean {
  return error instanceof Replaced || error instanceof Ended;
}

export function sentenceOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
