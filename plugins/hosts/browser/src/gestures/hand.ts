// The drawing hand: the effects of clicks, drags and strokes, depending on the object under them.
import type { Under, State } from '../state/state';
import type { Store } from '../state/store';
import type { CutWork } from '../actions/cut_work';
import type { DrawingWork } from '../actions/drawing_work';
import type { Live } from '../actions/live';
import type { DrawingHand, Touch } from './pointers';
import type { Finder } from './under';

/** Pixels; a smaller movement is a click. */
const still = 4;
/** Pixels between the points of a stroke. */
const strokeStep = 5;
/** Milliseconds within which a second finger means that the first was not meant to draw. */
const secondThoughts = 350;

type Press =
  | { kind: 'click'; on: Under }
  | { kind: 'stroke'; begun: number }
  | { kind: 'drag'; curve: number; point: number };

export class Hand implements DrawingHand {
  private pressed: Press | null = null;
  private start: Touch = { x: 0, y: 0, reach: 0, shift: false, time: 0 };
  private last: Touch = this.start;
  private clickBefore = { time: -1e9, x: 0, y: 0 };

  constructor(private readonly store: Store, private readonly finder: Finder,
              private readonly drawing: DrawingWork, private readonly live: Live,
              private readonly cutting: CutWork, private readonly partAt: (touch: Touch) => number | null) {}

  hover(touch: Touch | null): void {
    const state = this.store.now;
    const under = touch && isDrawable(state) ? this.find(touch) : { kind: 'nothing' as const };
    if (under.kind !== 'nothing' || state.under.kind !== 'nothing') this.store.set({ under });
    if (!state.drawing.unfinished) return;
    if (under.kind === 'nothing') this.live.dropLeg();
    else void this.live.leg(under.place);
  }

  press(touch: Touch): boolean {
    this.start = this.last = touch;
    this.pressed = null;
    const state = this.store.now;
    if (!isDrawable(state)) return false;
    const on = this.find(touch);
    if (on.kind === 'nothing') return false;
    this.store.set({ under: on });
    this.pressed = { kind: 'click', on };
    return true;
  }

  move(touch: Touch): void {
    const press = this.pressed;
    if (!press) return;
    const moved = Math.hypot(touch.x - this.start.x, touch.y - this.start.y);
    if (press.kind === 'click') {
      if (moved < still) return;
      this.pressed = this.beginMoving(press.on);
    }
    if (this.pressed?.kind === 'drag') this.drag(this.pressed, touch);
    if (this.pressed?.kind === 'stroke') this.paint(touch);
  }

  release(touch: Touch): void {
    const press = this.pressed;
    this.pressed = null;
    if (!press) return;
    if (press.kind === 'click') {
      this.click(press.on, touch.shift, this.isSecondClick(touch));
      return;
    }
    this.drawing.release();
    if (press.kind === 'stroke') this.endStroke(touch);
  }

  cancel(): void {
    const press = this.pressed;
    this.pressed = null;
    if (!press || press.kind === 'click') return;
    this.drawing.release();
    const hasty = press.kind === 'stroke' && performance.now() - press.begun < secondThoughts;
    if (hasty || press.kind === 'drag') this.drawing.undo();
  }

  /** On the cut mesh a tap keeps a part; beside the mesh it clears the choice. */
  tap(touch: Touch): void {
    const { cut, kept } = this.store.now;
    const part = cut && kept === null ? this.partAt(touch) : null;
    if (part !== null) void this.cutting.keep(part);
    if (!cut) this.drawing.choose(null);
  }

  /** A click by the keyboard, which has no double clicks. */
  keyClick(on: Under): void {
    this.click(on, false, false);
  }

  private click(on: Under, shift: boolean, again: boolean): void {
    const { drawing } = this.store.now;
    if (on.kind === 'mesh') {
      // A double click ends a curve; its second click adds no point.
      if (again && drawing.unfinished) this.drawing.finish();
      else {
        this.drawing.choose(null);
        this.drawing.addPoint(on.place);
      }
    } else if (on.kind === 'line') {
      const point = this.drawing.insert(on.curve, on.segment, on.place);
      if (point !== null) this.drawing.choose({ curve: on.curve, point });
    } else if (on.kind === 'point') {
      this.clickPoint(on, shift, again);
    }
  }

  private clickPoint(on: Extract<Under, { kind: 'point' }>, shift: boolean, again: boolean): void {
    const { drawing } = this.store.now;
    const points = drawing.curves[on.curve].points.length;
    const isCurrent = drawing.unfinished && on.curve === drawing.curves.length - 1;
    if (shift) this.drawing.removePoint(on);
    else if (isCurrent && on.point === 0 && points > 1) this.drawing.close();
    else if (isCurrent && on.point === points - 1 && points > 1) this.drawing.finish();
    else if (again && !isCurrent) this.drawing.togglePin(on);
    else this.drawing.choose({ curve: on.curve, point: on.point });
  }

  private beginMoving(on: Under): Press | null {
    this.drawing.grip();
    if (on.kind === 'point') {
      this.drawing.choose({ curve: on.curve, point: on.point });
      return { kind: 'drag', curve: on.curve, point: on.point };
    }
    if (on.kind === 'line') {
      const point = this.drawing.insert(on.curve, on.segment, on.place);
      if (point === null) return null;
      this.drawing.choose({ curve: on.curve, point });
      return { kind: 'drag', curve: on.curve, point };
    }
    if (on.kind !== 'mesh') return null;
    this.drawing.choose(null);
    this.live.dropLeg();
    this.drawing.paintPoint(on.place);
    return { kind: 'stroke', begun: performance.now() };
  }

  private drag(press: { curve: number; point: number }, touch: Touch): void {
    const place = this.finder.place(touch.x, touch.y);
    if (place) this.drawing.movePoint(press, place);
  }

  private paint(touch: Touch): void {
    if (Math.hypot(touch.x - this.last.x, touch.y - this.last.y) < strokeStep) return;
    const place = this.finder.place(touch.x, touch.y);
    if (!place) return;
    this.last = touch;
    this.drawing.paintPoint(place);
  }

  /** A stroke that returns to the first point of its curve closes the curve. */
  private endStroke(touch: Touch): void {
    const first = this.finder.firstPoint(this.store.now);
    const points = this.drawing.current()?.points.length ?? 0;
    if (!first || points < 8) return;
    if (Math.hypot(first.x - touch.x, first.y - touch.y) <= 1.5 * touch.reach) this.drawing.close();
  }

  private find(touch: Touch): Under {
    return this.finder.under(touch.x, touch.y, touch.reach, this.store.now);
  }

  private isSecondClick(touch: Touch): boolean {
    const before = this.clickBefore;
    const again = touch.time - before.time < 400 && Math.hypot(touch.x - before.x, touch.y - before.y) < 2 * still;
    this.clickBefore = again ? { time: 0, x: 0, y: 0 } : { time: touch.time, x: touch.x, y: touch.y };
    return again;
  }
}

export function isDrawable(state: State): boolean {
  return state.mesh !== null && !state.opening && state.mesh.info.defects === null && state.cut === null;
}
