// The edits of the drawing. Each edit is a step of undo; a refused edit says why.
import type { Editor } from '../engine/editor';
import type { Curve, Line, Point } from '../engine/types';
import { type Chosen, nameOf, type Place } from '../state/state';
import { areJoined } from '../pick/parts';
import { positionOf } from '../view/vectors';
import { type Desk, sentenceOf } from './desk';
import { type Hand, type Live, offsetStep } from './live';

export class DrawingWork {
  constructor(private readonly desk: Desk, private readonly live: Live) {}

  /** Makes an edit and smooths the drawing. Returns whether the editor accepted the edit. */
  edit(change: (editor: Editor) => void, told = '', hand: Hand = 'rests'): boolean {
    const taken = this.step(change, told, hand);
    if (taken) this.desk.openings?.forgetRedo();
    return taken;
  }

  /** `change` returns true where curves and settings stay as they are. */
  private step(change: (editor: Editor) => unknown, told: string, hand: Hand): boolean {
    const { store, editor } = this.desk;
    if (store.now.opening) return false;
    let stays: boolean;
    try {
      stays = change(editor) === true;
      store.goOn();
    } catch (error) {
      store.trouble('drawing', sentenceOf(error));
      return false;
    }
    if (told) this.desk.tell(told);
    if (stays) this.live.take();
    else this.live.refresh(hand);
    return true;
  }

  /** Edits between grip() and release() are one step of undo. */
  grip(): void {
    this.desk.editor.beginGesture();
  }

  release(): void {
    this.desk.editor.endGesture();
    this.live.refresh();
  }

  addPoint(place: Place): void {
    if (!this.isReached(this.current()?.points[0], place)) return;
    const begins = !this.desk.store.now.drawing.unfinished;
    this.edit((e) => e.addPoint(bare(place)));
    const curve = this.current();
    if (curve) this.desk.tell(begins ? `${nameOf(curve)} begins.` : `Point ${curve.points.length}.`);
  }

  paintPoint(place: Place): void {
    if (!this.isReached(this.current()?.points[0], place)) return;
    this.edit((e) => e.paintPoint(bare(place)), '', 'drags');
  }

  takeBack(): void {
    this.edit((e) => e.takeBackPoint(), 'Took back a point.');
  }

  finish(): void {
    this.edit((e) => e.finishCurve(), 'The curve is finished.');
  }

  close(): void {
    this.edit((e) => e.closeCurve(), 'The curve is closed.');
  }

  drop(): void {
    this.edit((e) => e.dropCurve(), 'Dropped the curve.');
  }

  movePoint(chosen: { curve: number; point: number }, place: Place): void {
    const { points } = this.desk.store.now.drawing.curves[chosen.curve];
    if (!this.isReached(points.length > 1 ? points[chosen.point] : undefined, place)) return;
    this.edit((e) => e.movePoint(chosen.curve, chosen.point, bare(place)), '', 'drags');
  }

  /** Adds a point at the picked place of a curve; returns its index, or null. */
  insert(curve: number, segment: number, place: Place): number | null {
    const { drawing, smoothed, drawn, mesh } = this.desk.store.now;
    const line = smoothed?.curves[curve] ?? drawn[curve];
    if (!mesh || !line) return null;
    const given = drawing.curves[curve].points.flatMap((point: Point) => positionOf(mesh.info, point));
    let before = 0;
    const took = this.edit((e) => {
      before = e.legAt(new Float64Array(given), line.positions, line.closed, segment);
      e.insertPoint(curve, before, bare(place));
    }, 'Added a point.');
    return took ? before : null;
  }

  removePoint({ curve, point }: { curve: number; point: number }): void {
    if (this.edit((e) => e.removePoint(curve, point), 'Removed the point.')) {
      this.choose(null);
    }
  }

  togglePin({ curve, point }: { curve: number; point: number }): void {
    const pinned = !this.desk.store.now.drawing.curves[curve].points[point].pinned;
    this.edit((e) => e.setPinned(curve, point, pinned), pinned ? 'Pinned the point.' : 'Unpinned the point.');
  }

  addCurves(curves: Curve[]): void {
    this.grip();
    for (const curve of curves) this.edit((e) => e.addCurve(curve), '', 'drags');
    this.release();
    this.desk.tell(`Added ${curves.length} ${curves.length === 1 ? 'curve' : 'curves'}.`);
  }

  /** Undoes the last step; before the first step of the drawing, the opening of its mesh. */
  undo(): void {
    const { editor, openings } = this.desk;
    if (editor.undoName() === null && openings?.undoName()) openings.undo();
    else this.back((e) => e.undo(), 'Undid', 'Nothing to undo.');
  }

  redo(): void {
    const { editor, openings } = this.desk;
    if (editor.redoName() === null && openings?.redoName()) openings.redo();
    else this.back((e) => e.redo(), 'Redid', 'Nothing to redo.');
  }

  private back(step: (editor: Editor) => string | null, did: string, nothing: string): void {
    let name: string | null = null;
    this.step((e) => (name = step(e)) === offsetStep, '', 'rests');
    this.desk.tell(name ? `${did}: ${String(name)}.` : nothing);
  }

  choose(chosen: Chosen | null): void {
    this.desk.store.set({ chosen });
  }

  /** Whether a curve through the point can reach the place; if not, the user is told. */
  private isReached(point: Point | undefined, place: Place): boolean {
    const { store } = this.desk;
    const { mesh } = store.now;
    if (!mesh || !point || areJoined(mesh.info, point.face, place.face)) return true;
    store.trouble('drawing', 'This point is on another part of the mesh, and no curve gets there from here.');
    return false;
  }

  /** The curve that is being drawn. */
  current(): Curve | null {
    const { drawing } = this.desk.store.now;
    return drawing.unfinished ? (drawing.curves.at(-1) ?? null) : null;
  }

  /** The curves that can be picked: the smoothed ones, or the drawn ones until the smoothed ones
     exist. */
  lines(): Line[] {
    const { smoothed, drawn } = this.desk.store.now;
    return smoothed?.curves ?? drawn;
  }
}

function bare({ face, barycentric }: Place) {
  return { face, barycentric };
}
