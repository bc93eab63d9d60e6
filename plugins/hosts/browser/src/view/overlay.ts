// What lies over the canvas at places of the mesh: the keyboard's cursor, where curves deviate most, and
// lengths. These are elements of the page, sharp at every size.
import type { Vec3 } from '../engine/types';
import type { Stage } from './stage';

export interface Mark {
  /** The first of these that is seen, or for a mark of one place that. */
  places: Vec3[];
  /** Of each the next place of a curve, beside which the text stands; without them the text is to the right. */
  ahead?: Vec3[];
  text: string;
}

interface Placed extends Mark {
  /** Which place it has; it stays there while that is seen. */
  now: number;
  label: HTMLElement | null;
}

/** Pixels between a curve and its label. */
const gap = 7;

export class Overlay {
  private placed = new Map<HTMLElement, Placed>();

  /** `isSeen`: whether nothing lies before a place. */
  constructor(private readonly stage: Stage, private readonly box: HTMLElement,
              private readonly isSeen: (place: Vec3) => boolean) {
    stage.afterEach(() => this.follow());
  }

  /** Marks of a class, each with a text beside it, in place of those that were there. */
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
    for (const [element, placed] of this.placed) {
      const place = this.placeOf(placed);
      const at = place && this.stage.onScreen(place);
      element.hidden = !at;
      if (!at) continue;
      element.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
      if (placed.ahead) this.putBeside(placed, at);
    }
  }

  /** Puts the label to the side of its curve that is lower. */
  private putBeside({ label, ahead, now }: Placed, at: { x: number; y: number }): void {
    const next = ahead && this.stage.onScreen(ahead[now]);
    if (!label || !next) return;
    const dx = next.x - at.x, dy = next.y - at.y, length = Math.hypot(dx, dy) || 1;
    const sign = dx < 0 ? -1 : 1, across = { x: (-sign * dy) / length, y: (sign * dx) / length };
    const width = label.offsetWidth, height = label.offsetHeight;
    const away = gap + (width * Math.abs(across.x) + height * Math.abs(across.y)) / 2;
    label.style.left = `${(across.x * away - width / 2).toFixed(1)}px`;
    label.style.top = `${(across.y * away - height / 2).toFixed(1)}px`;
  }

  private placeOf(placed: Placed): Vec3 | null {
    const { places } = placed;
    if (places.length === 1) return places[0];
    for (let k = 0; k < places.length; ++k) {
      const next = (placed.now + k) % places.length;
      if (!this.stage.isInView(places[next]) || !this.isSeen(places[next])) continue;
      placed.now = next;
      return places[next];
    }
    return null;
  }
}
