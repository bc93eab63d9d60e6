// Cuts the mesh along the smoothed curves, and keeps parts of it.
import type { Desk } from './desk';
import type { DrawingWork } from './drawing_work';

export class CutWork {
  private alongOffset = false;

  constructor(private readonly desk: Desk, private readonly drawing: DrawingWork) {}

  /** Along the smoothed curves, or along their offset. */
  async cut(alongOffset = false): Promise<void> {
    const { store, engine } = this.desk;
    const { drawing, opening } = store.now;
    if (opening) return;
    const cut = await this.desk.wait('cut', 'Cutting', engine.cut(drawing, alongOffset));
    if (!cut || store.now.drawing !== drawing) return;
    this.alongOffset = alongOffset;
    store.set({ cut, kept: null, leg: null });
    const parts = cut.parts === 1 ? 'The curves do not take the mesh apart.' : `${cut.parts} parts.`;
    this.desk.tell([parts, ...cut.notes].join(' '));
  }

  /** All parts of the last cut. */
  again(): Promise<void> {
    return this.cut(this.alongOffset);
  }

  /** Shows one part alone. */
  async keep(part: number): Promise<void> {
    const { store, engine } = this.desk;
    const kept = await this.desk.wait('cut', 'Keeping a part', engine.keep(part, store.now.lids));
    if (!kept || !store.now.cut) return;
    // It keeps the number and the colour that it had among the others.
    store.set({ cut: { ...kept, side: kept.side.fill(part), parts: part + 1 }, kept: part });
    this.desk.tell(`Part ${part + 1} is kept.`);
  }

  async setLids(lids: boolean): Promise<void> {
    const { store } = this.desk;
    store.set({ lids });
    if (store.now.kept !== null) await this.keep(store.now.kept);
  }

  /** Back to the whole mesh, to draw on. */
  uncut(): void {
    this.desk.store.set({ cut: null, kept: null });
    this.desk.store.trouble('cut', null);
    this.desk.tell('The whole mesh.');
  }

  /** Borders of labels become curves of the drawing. `text`: a number per face; null: the mesh's. */
  async borders(text: string | null): Promise<void> {
    const values = text === null ? null : labelsOf(text);
    const curves = await this.desk.wait('cut', 'Finding borders', this.desk.engine.labels(values));
    if (curves) this.drawing.addCurves(curves);
  }
}

function labelsOf(text: string): Int32Array {
  return Int32Array.from(text.split(/\s+/).filter(Boolean), Number);
}
