// Curves at a distance from the smoothed curves, updated when the hand rests.
import type { OffsetSettings } from '../engine/types';
import type { State } from '../state/state';
import { type Desk, sentenceOf } from './desk';
import { type Live, offsetStep } from './live';

export class OffsetWork {
  /** The choices of the newest offset. */
  private made = '';

  constructor(private readonly desk: Desk, private readonly live: Live) {
    desk.store.watch((now, before) => {
      if (now.smoothed !== before.smoothed || choices(now) !== this.made) void this.make(now);
    });
  }

  /** A step that can be undone. Returns whether the editor took it. */
  set(parts: Partial<OffsetSettings>): boolean {
    const { store, editor, openings } = this.desk;
    if (store.now.opening) return false;
    try {
      editor.setOffset({ ...store.now.drawing.offset, ...parts });
    } catch (error) {
      store.trouble('offset', sentenceOf(error));
      return false;
    }
    openings?.forgetRedo();
    this.live.take();
    return true;
  }

  /** Settings between grip() and release() are one step of undo. */
  grip(): void {
    this.desk.editor.beginGesture(offsetStep);
  }

  release(): void {
    this.desk.editor.endGesture();
  }

  private async make(state: State): Promise<void> {
    const { store, engine } = this.desk;
    const { smoothed, drawing } = state;
    const { on, of, distance, side, caps } = drawing.offset;
    this.made = choices(state);
    const curves = drawing.curves.flatMap(({ number }, k) =>
      smoothed?.curves[k] && (of === null || of === number) ? [k] : []);
    if (!on || !smoothed?.final || curves.length === 0) {
      if (store.now.offsets) store.set({ offsets: null });
      store.trouble('offset', null);
      return;
    }
    const work = engine.offset({ curves, distance, side, caps });
    const offsets = await this.desk.wait('offset', 'Finding the offset', work);
    if (store.now.smoothed !== smoothed || choices(store.now) !== choices(state)) return;
    store.set({ offsets: offsets ?? null });
  }
}

function choices({ drawing }: State): string {
  return JSON.stringify(drawing.offset);
}
