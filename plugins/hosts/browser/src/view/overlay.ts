// Marks over the canvas at places of the mesh: the keyboard's cursor, largest deviations, and
// lengths. Marks are elements of the page, sharp at every size.
import type { Vec3 } from '../engine/types';
import type { Stage } from './stage';

export interface Mark {
  /** With `ahead` the mark takes the first suitable place; without, there is one place. */
  places: Vec3[];
  /** For each place the next place on the curve, so that the text stands beside the curve; without,
     the text is to the right. */
  ahead?: Vec3[];
  text: string;
}

interface Placed extends Mark {
  /** The index of its place, which stays while the place is visible. */
  now: number;
  label: HTMLElement | null;
}

/** Pixels between a curve and its label. */
const gap = 7;

interface Pixel {
  x: number;
  y: number;
}

/** The rectangle of a label on the screen. */
interface Box extends Pixel {
  width: number;
  height: number;
}

export class Overlay {
  private placed = new Map<HTMLElement, Placed>();

  /** `isSeen`: whether a place is visible. */
  constructor(private readonly stage: Stage, private readonly box: HTMLElement,
              private readonly isSeen: (place: Vec3) => boolean) {
    stage.afterEach(() => this.follow());
  }

  /** Replaces the marks of a class; each mark has a text beside it. */
  mark(name: string, marks: Mark[]): void {
    for (const element of [...this.placed.keys()].filter((e) => e.classList.contains(name))) {
      this.placed.delete(element);
      element.remove();
    }
    for (const mark of marks) {
      const { text } = mark;
      let label: HTMLElement | null = null;
      const element = document.createElement('div');
      element.className = `mark ${name}`;
      element.append(document.createElement('i'));
      if (text) {
        label = document.createElement('span');
        label.textContent = text;
        element.append(label);
      }
      this.box.append(element);
      this.placed.set(element, { ...mark, now: 0, label });
    }
    this.stage.ask();
  }

  private follow(): void {
    const taken: Box[] = [];
    for (const [element, placed] of this.placed) {
      const at = placed.ahead ? this.besideCurve(placed, taken) : this.stage.onScreen(placed.places[0]);
      element.hidden = !at;
      if (at) element.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
    }
  }

  /** Puts a label beside the first visible place that is free of other labels; null: there is
     none. */
  private besideCurve(placed: Placed, taken: Box[]): Pixel | null {
    const { places, ahead, label } = placed;
    if (!label || !ahead) return null;
    label.parentElement!.hidden = false;  // a hidden element has no size
    const width = label.offsetWidth, height = label.offsetHeight;
    for (let k = 0; k < places.length; ++k) {
      const next = (placed.now + k) % places.length;
      if (!this.stage.isInView(places[next]) || !this.isSeen(places[next])) continue;
      const at = this.stage.onScreen(places[next]), to = this.stage.onScreen(ahead[next]);
      if (!at || !to) continue;
      const box = boxBeside(at, to, width, height);
      if (taken.some((other) => overlap(box, other))) continue;
      taken.push(box);
      placed.now = next;
      label.style.left = `${(box.x - at.x).toFixed(1)}px`;
      label.style.top = `${(box.y - at.y).toFixed(1)}px`;
      return at;
    }
    return null;
  }
}

/** A box of this size on the lower side of a line between two pixels. */
function boxBeside(at: Pixel, to: Pixel, width: number, height: number): Box {
  const dx = to.x - at.x, dy = to.y - at.y, length = Math.hypot(dx, dy) || 1;
  const sign = dx < 0 ? -1 : 1, across = { x: (-sign * dy) / length, y: (sign * dx) / length };
  const away = gap + (width * Math.abs(across.x) + height * Math.abs(across.y)) / 2;
  return { x: at.x + across.x * away - width / 2, y: at.y + across.y * away - height / 2, width, height };
}

function overlap(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}
