// Keeps the smoothed curve beside the drawing: after every edit the newest drawing is smoothed.
import type { Drawing, Line } from '../engine/types';
import { emptyDrawing, type Comb, type Place } from '../state/state';
import { type Desk, isGone, sentenceOf } from './desk';

/** The state of the hand: during a movement only visible results are computed. */
export type Hand = 'rests' | 'slides' | 'drags';

/** The editor's name of steps that change only the offset. */
export const offsetStep = 'Offset';

/** The name of work that smooths curves. */
export const smoothingWords = 'Smoothing';

export class Live {
  private round = 0;
  /** The newest round whose answer is shown; answers of older rounds are dropped. */
  private shown = 0;
  private legRound = 0;
  private drawnOf: Drawing['curves'] = [];

  constructor(private readonly desk: Desk) {}

  /** Takes the drawing from the editor. */
  take(): Drawing {
    const { editor, store } = this.desk;
    const drawing = editor.drawing();
    store.set({ drawing, chosen: stillThere(store.now.chosen, drawing) });
    this.nameSteps();
    return drawing;
  }

  /** Takes the drawing from the editor and smooths it. A cut along earlier curves is dropped. */
  refresh(hand: Hand = 'rests'): void {
    const { store } = this.desk;
    const drawing = this.take();
    store.set({ cut: null, kept: null });
    if (!drawing.unfinished) this.dropLeg();
    if (!drawable(drawing)) {
      this.shown = ++this.round;
      this.drawnOf = [];
      store.set({ drawn: [], smoothed: null, combs: [] });
      return;
    }
    void this.smooth(drawing, hand);
    if (!sameCurves(this.drawnOf, drawing.curves)) void this.draw(drawing);
  }

  /** Drops all data of the mesh. */
  reset(): void {
    this.shown = ++this.round;
    this.drawnOf = [];
    this.dropLeg();
    this.desk.store.set({
      drawing: emptyDrawing, drawn: [], smoothed: null, combs: [], offsets: null, cut: null, kept: null,
      chosen: null, cursor: null, under: { kind: 'nothing' },
    });
    this.nameSteps();
  }

  /** Shows the names of the steps for undo and redo. */
  nameSteps(): void {
    const { editor, openings, store } = this.desk;
    store.set({
      undo: editor.undoName() ?? openings?.undoName() ?? null,
      redo: editor.redoName() ?? openings?.redoName() ?? null,
    });
  }

  /** Shows the leg from the last point to a place. */
  async leg(to: Place): Promise<void> {
    const { store, engine } = this.desk;
    const { drawing } = store.now;
    const last = drawing.unfinished ? drawing.curves.at(-1)?.points.at(-1) : undefined;
    if (!last || store.now.opening) return;
    const mine = ++this.legRound;
    try {
      const { face, barycentric } = to;
      const leg = await engine.leg(last, { face, barycentric, pinned: false, exact: 0 });
      if (mine === this.legRound) store.set({ leg });
    } catch (error) {
      // A leg is a preview: without one nothing is shown, and a click says why.
      if (!isGone(error) && mine === this.legRound) store.set({ leg: null });
    }
  }

  dropLeg(): void {
    ++this.legRound;
    if (this.desk.store.now.leg) this.desk.store.set({ leg: null });
  }

  /** Computes the combs, if they are shown. */
  async combs(): Promise<void> {
    const { store, engine } = this.desk;
    const { mesh, show, smoothed } = store.now;
    if (!show.comb || !mesh || !smoothed) return;
    try {
      const spacing = combSpacing(smoothed.curves);
      const combs: Comb[] = await Promise.all(smoothed.curves.map((_, k) => engine.comb(k, spacing)));
      if (store.now.smoothed === smoothed) store.set({ combs });
    } catch (error) {
      if (!isGone(error)) store.trouble('drawing', sentenceOf(error));
    }
  }

  private async smooth(drawing: Drawing, hand: Hand): Promise<void> {
    const mine = ++this.round;
    const { store, engine } = this.desk;
    const work = engine.smooth(drawing, hand);
    const smoothed = await (hand === 'rests' ? this.desk.wait('drawing', smoothingWords, work)
      : work.catch(() => undefined));
    // During a movement an older answer is shown, unless a newer answer is already shown.
    if (!smoothed || mine < this.shown) return;
    this.shown = mine;
    store.set({ smoothed });
    void this.combs();
  }

  private async draw(drawing: Drawing): Promise<void> {
    this.drawnOf = drawing.curves;
    try {
      const drawn = await this.desk.engine.draw(drawing);
      if (this.drawnOf === drawing.curves) this.desk.store.set({ drawn });
    } catch (error) {
      if (!isGone(error)) this.desk.store.trouble('drawing', sentenceOf(error));
    }
  }
}

function drawable(drawing: Drawing): boolean {
  return drawing.curves.some((curve) => curve.points.length > 1);
}

function sameCurves(a: Drawing['curves'], b: Drawing['curves']): boolean {
  return a.length === b.length && JSON.stringify(a) === JSON.stringify(b);
}

function stillThere<T extends { curve: number; point: number | null }>(chosen: T | null, drawing: Drawing) {
  const curve = chosen ? drawing.curves[chosen.curve] : undefined;
  if (!chosen || !curve) return null;
  if (chosen.point !== null && chosen.point >= curve.points.length) return { ...chosen, point: null };
  return chosen;
}

/** About 150 teeth on the longest curve. */
function combSpacing(curves: Line[]): number {
  return Math.max(...curves.map((curve) => curve.report.length)) / 150;
}
