// Cuts the mesh along the smoothed curves, and keeps single parts.
import { countText } from '../state/numbers';
import type { Desk } from './desk';
import type { DrawingWork } from './drawing_work';

export class CutWork {
  private alongOffset = false;

  constructor(private readonly desk: Desk, private readonly drawing: DrawingWork) {}

  /** Cuts along the smoothed curves, or along their offset. */
  async cut(alongOffset = false): Promise<void> {
    const { store, engine } = this.desk;
    const { drawing, opening } = store.now;
    if (opening) return;
    const cut = await this.desk.wait('cut', 'Cutting', engine.cut(drawing, alongOffset));
    if (!cut || store.now.drawing !== drawing) return;
    this.alongOffset = alongOffset;
    store.set({ cut, kept: null, leg: null });
    const parts = cut.parts === 1 ? 'The curves do not take the mesh apart.'
      : `The mesh is cut into ${countText(cut.parts)} parts.`;
    const listed = store.now.mesh?.info.repaired?.changes ?? [];  // the panel already lists them beside the mesh
    this.desk.tell([parts, ...cut.notes.filter((note) => !listed.includes(note))].join(' '));
  }

  /** Shows all parts of the last cut again. */
  again(): Promise<void> {
    return this.cut(this.alongOffset);
  }

  /** Shows one part alone. */
  async keep(part: number): Promise<void> {
    const { store, engine } = this.desk;
    const kept = await this.desk.wait('cut', 'Keeping a part', engine.keep(part, store.now.lids));
    if (!kept || !store.now.cut) return;
    // The part keeps its number and its colour.
    store.set({ cut: { ...kept, side: kept.side.fill(part), parts: part + 1 }, kept: part });
    this.desk.tell(`Part ${part + 1} is kept.`);
  }

  async setLids(lids: boolean): Promise<void> {
    const { store } = this.desk;
    store.set({ lids });
    if (store.now.kept !== null) await this.keep(store.now.kept);
  }

  /** Shows the whole mesh again, to draw on it. */
  uncut(): void {
    this.desk.store.set({ cut: null, kept: null });
    this.desk.store.trouble('cut', null);
    this.desk.tell('The whole mesh.');
  }

  /** Adds borders of labels as curves of the drawing. `text`: a number for each face; null: the
     mesh's own labels. */
  async borders(text: string | null): Promise<void> {
    const values = text === null ? null : labelsOf(text);
    const curves = await this.desk.wait('cut', 'Finding borders', this.desk.engine.labels(values));
    if (curves) this.drawing.addCurves(curves);
  }
}

function labelsOf(text: string): Int32Array {
  return Int32Array.from(text.split(/\s+/).filter(Boolean), Number);
}
