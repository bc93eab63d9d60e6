// Interprets mouse, fingers and pen: the left button, one finger and a pen draw; the other buttons,
// the wheel and two fingers move the view.
import type { ViewCamera } from '../view/camera';

/** A place on the canvas, with the precision of the device. */
export interface Touch {
  x: number;
  y: number;
  /** Pixels around a point within which it is grabbed. */
  reach: number;
  shift: boolean;
  /** Time of the event, ms. */
  time: number;
}

/** The actions of the drawing hand. move() comes only after press(). */
export interface DrawingHand {
  hover(touch: Touch | null): void;
  /** false: nothing can be drawn here, so the view turns instead. */
  press(touch: Touch): boolean;
  move(touch: Touch): void;
  release(touch: Touch): void;
  /** The movement since press() belongs to the view. */
  cancel(): void;
  /** A click for which press() returned false. */
  tap(touch: Touch): void;
}

type Doing = 'nothing' | 'drawing' | 'turning' | 'panning' | 'fingers';

export class Pointers {
  private doing: Doing = 'nothing';
  private readonly fingers = new Map<number, { x: number; y: number }>();
  private last = { x: 0, y: 0 };
  private way = 0;
  private mine: number | null = null;

  constructor(private readonly area: HTMLElement, private readonly camera: ViewCamera,
              private readonly hand: DrawingHand, private readonly viewMoved: () => void) {
    area.addEventListener('pointerdown', (e) => this.down(e));
    area.addEventListener('pointermove', (e) => this.moved(e));
    area.addEventListener('pointerup', (e) => this.up(e));
    area.addEventListener('pointercancel', (e) => this.up(e, true));
    area.addEventListener('pointerleave', () => this.hand.hover(null));
    area.addEventListener('contextmenu', (e) => e.preventDefault());
    area.addEventListener('wheel', (e) => this.wheel(e), { passive: false });
  }

  private touchOf(event: PointerEvent): Touch {
    const box = this.area.getBoundingClientRect();
    return {
      x: event.clientX - box.left, y: event.clientY - box.top,
      reach: event.pointerType === 'touch' ? 24 : event.pointerType === 'pen' ? 14 : 11,
      shift: event.shiftKey,
      time: event.timeStamp,
    };
  }

  private down(event: PointerEvent): void {
    this.area.focus({ preventScroll: true });
    const touch = this.touchOf(event);
    if (event.pointerType === 'touch') {
      // While a pen draws, fingers on the screen are ignored.
      if (this.doing === 'drawing' && this.fingers.size === 0) return;
      this.fingers.set(event.pointerId, touch);
      if (this.fingers.size > 1) {
        if (this.doing === 'drawing') this.hand.cancel();
        this.doing = 'fingers';
        this.capture(event);
        return;
      }
    } else if (event.pointerType === 'pen' && this.doing !== 'nothing') {
      this.fingers.clear();
      if (this.doing === 'drawing') this.hand.cancel();
    } else if (this.doing !== 'nothing') {
      return;
    }
    this.capture(event);
    this.mine = event.pointerId;
    this.last = touch;
    this.way = 0;
    if (event.button === 1) this.doing = 'panning';
    else if (event.button === 2) this.doing = event.shiftKey ? 'panning' : 'turning';
    else this.doing = this.hand.press(touch) ? 'drawing' : 'turning';
    if (event.button === 1) event.preventDefault();
  }

  private moved(event: PointerEvent): void {
    const touch = this.touchOf(event);
    if (this.doing === 'nothing') {
      if (event.pointerType !== 'touch') this.hand.hover(touch);
      return;
    }
    if (this.doing === 'fingers') {
      if (this.fingers.has(event.pointerId)) this.fingersMoved(event.pointerId, touch);
      return;
    }
    if (event.pointerId !== this.mine) return;
    if (this.doing === 'drawing') {
      // All positions since the last frame, so that quick strokes stay round.
      const all = event.getCoalescedEvents?.() ?? [];
      for (const one of all.length > 0 ? all : [event]) this.hand.move(this.touchOf(one));
      return;
    }
    const dx = touch.x - this.last.x, dy = touch.y - this.last.y;
    this.last = touch;
    this.way += Math.hypot(dx, dy);
    if (this.doing === 'turning') this.camera.orbit(dx, dy);
    else this.camera.pan(dx, dy);
    this.viewMoved();
  }

  /** Two fingers turn, zoom and roll the view; three move it. */
  private fingersMoved(id: number, touch: Touch): void {
    const before = [...this.fingers.values()];
    this.fingers.set(id, touch);
    const after = [...this.fingers.values()];
    const m = middle(before), n = middle(after);
    if (after.length > 2) this.camera.pan(n.x - m.x, n.y - m.y);
    else if (after.length === 2) {
      this.camera.orbit(n.x - m.x, n.y - m.y);
      const [a, b] = [between(before), between(after)];
      if (a.length > 10 && b.length > 10) {
        this.camera.zoom(a.length / b.length, n.x, n.y);
        this.camera.roll(turnBetween(a.angle, b.angle));
      }
    }
    this.viewMoved();
  }

  private up(event: PointerEvent, cancelled = false): void {
    const wasFinger = this.fingers.delete(event.pointerId);
    if (this.doing === 'fingers') {
      if (this.fingers.size === 0) this.doing = 'nothing';
      return;
    }
    if (event.pointerId !== this.mine) return;
    const { doing } = this;
    this.doing = 'nothing';
    this.mine = null;
    if (doing === 'turning' && this.way < 4 && event.button === 0) this.hand.tap(this.touchOf(event));
    if (doing !== 'drawing') return;
    if (cancelled) this.hand.cancel();
    else this.hand.release(this.touchOf(event));
    if (wasFinger) this.hand.hover(null);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const box = this.area.getBoundingClientRect();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    const by = Math.max(-150, Math.min(150, event.deltaY * lines));
    // Browsers report a pinch on a touch pad as a wheel with Ctrl, in small steps.
    const factor = Math.exp(by * (event.ctrlKey ? 0.01 : 0.0018));
    this.camera.zoom(factor, event.clientX - box.left, event.clientY - box.top);
    this.viewMoved();
  }

  private capture(event: PointerEvent): void {
    try {
      this.area.setPointerCapture(event.pointerId);
    } catch {
      // The pointer is already gone; its end is reported without capture.
    }
  }
}

function middle(all: { x: number; y: number }[]) {
  const sum = all.reduce((a, b) => ({ x: a.x + b.x, y: a.y + b.y }));
  return { x: sum.x / all.length, y: sum.y / all.length };
}

function between([a, b]: { x: number; y: number }[]) {
  return { length: Math.hypot(b.x - a.x, b.y - a.y), angle: Math.atan2(b.y - a.y, b.x - a.x) };
}

function turnBetween(a: number, b: number): number {
  const turn = b - a;
  return Math.atan2(Math.sin(turn), Math.cos(turn));
}
