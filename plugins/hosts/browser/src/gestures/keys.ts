// The keys of the view. The help is made from this list, so every key is in the help.
import type { Store } from '../state/store';
import type { ViewCamera } from '../view/camera';
import type { DrawingWork } from '../actions/drawing_work';
import type { CutWork } from '../actions/cut_work';
import type { Live } from '../actions/live';
import type { Cursor } from './cursor';
import { type Hand, isDrawable } from './hand';

export interface Key {
  /** As KeyboardEvent.key, several for one; letters in lower case. */
  keys: string[];
  shown: string;
  what: string;
  /** Works on the whole page, with Ctrl or ⌘. */
  control?: boolean;
  act(event: KeyboardEvent): void;
}

const ways: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
};
const turns: Record<string, [number, number]> = { a: [1, 0], d: [-1, 0], w: [0, 1], s: [0, -1] };

export class Keys {
  readonly all: Key[];
  /** The point that arrow keys move. */
  private carried: { curve: number; point: number } | null = null;

  constructor(area: HTMLElement, private readonly store: Store,
              private readonly camera: ViewCamera, private readonly cursor: Cursor,
              private readonly hand: Hand, private readonly drawing: DrawingWork,
              private readonly live: Live, private readonly cutting: CutWork,
              private readonly viewMoved: () => void) {
    this.all = [...this.drawingKeys(), ...this.pointKeys(), ...this.viewKeys()];
    area.addEventListener('keydown', (event) => this.pressed(event, false));
    document.addEventListener('keydown', (event) => this.pressed(event, true));
    area.addEventListener('pointerdown', () => this.dropCarried(), { capture: true });
    area.addEventListener('blur', () => this.dropCarried());
  }

  pinChosen(): void {
    this.withPoint((point) => this.drawing.togglePin(point));
  }

  removeChosen(): void {
    this.withPoint((point) => this.drawing.removePoint(point));
  }

  private pressed(event: KeyboardEvent, page: boolean): void {
    if (event.defaultPrevented || event.altKey) return;
    const control = event.ctrlKey || event.metaKey;
    // In text boxes Ctrl+Z belongs to the text.
    if (page && (isText(event.target) || !(control || this.leavesCut(event)))) return;
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const key = this.all.find((k) => !!k.control === control && k.keys.includes(name));
    if (!key) return;
    event.preventDefault();
    key.act(event);
  }

  /** The focus is still on the button that has cut. */
  private leavesCut(event: KeyboardEvent): boolean {
    return event.key === 'Escape' && this.store.now.cut !== null && !(event.target as Element).closest('dialog');
  }

  private drawingKeys(): Key[] {
    const { drawing } = this;
    return [
      { keys: Object.keys(ways), shown: '← ↑ → ↓', what: 'move the cursor over the mesh (Shift: finely)',
        act: (e) => this.moveCursor(e) },
      { keys: [' '], shown: 'Space', what: 'click at the cursor: add a point, close at the first one, insert on a curve',
        act: () => this.clickAtCursor() },
      { keys: ['Enter'], shown: 'Enter', what: 'finish the curve', act: () => this.finish() },
      { keys: ['c'], shown: 'C', what: 'close the curve', act: () => this.current() && drawing.close() },
      { keys: ['Backspace'], shown: 'Backspace', what: 'take the last point back', act: () => this.takeBack() },
      { keys: ['Escape'], shown: 'Esc', what: 'drop the curve that is being drawn; release a point; leave a cut',
        act: () => this.escape() },
      { keys: ['z'], shown: 'Ctrl+Z', control: true, what: 'undo (with Shift: redo)',
        act: (e) => (e.shiftKey ? drawing.redo() : drawing.undo()) },
      { keys: ['y'], shown: 'Ctrl+Y', control: true, what: 'redo', act: () => drawing.redo() },
    ];
  }

  private pointKeys(): Key[] {
    return [
      { keys: ['n'], shown: 'N', what: 'go to the next point (Shift: the one before)',
        act: (e) => this.cursor.nextPoint(e.shiftKey ? -1 : 1) },
      { keys: ['m'], shown: 'M', what: 'move the chosen point with the arrow keys; again: release it',
        act: () => this.carry() },
      { keys: ['p'], shown: 'P', what: 'pin or unpin the chosen point',
        act: () => this.pinChosen() },
      { keys: ['Delete', 'x'], shown: 'Delete, X', what: 'remove the chosen point',
        act: () => this.removeChosen() },
    ];
  }

  private viewKeys(): Key[] {
    const moved = (task: () => void) => () => {
      task();
      this.viewMoved();
    };
    return [
      { keys: Object.keys(turns), shown: 'W A S D', what: 'turn the view (Shift: shift it)', act: (e) => this.turn(e) },
      { keys: ['q'], shown: 'Q', what: 'roll to the left', act: moved(() => this.camera.roll(-0.1)) },
      { keys: ['e'], shown: 'E', what: 'roll to the right', act: moved(() => this.camera.roll(0.1)) },
      { keys: ['+', '='], shown: '+', what: 'nearer', act: moved(() => this.camera.zoom(0.87)) },
      { keys: ['-'], shown: '−', what: 'farther', act: moved(() => this.camera.zoom(1.15)) },
      { keys: ['f', 'Home'], shown: 'F, Home', what: 'show everything', act: moved(() => this.camera.fit()) },
    ];
  }

  private moveCursor(event: KeyboardEvent): void {
    const [x, y] = ways[event.key];
    const step = event.shiftKey ? 2 : 14;
    const place = this.cursor.move(x * step, y * step);
    if (!place) return;
    if (this.carried) this.drawing.movePoint(this.carried, place);
    else if (this.store.now.drawing.unfinished) void this.live.leg(place);
  }

  private clickAtCursor(): void {
    if (this.carried) {
      this.dropCarried();
      return;
    }
    const touch = this.cursor.touch();
    if (touch && isDrawable(this.store.now)) this.hand.keyClick(this.cursor.under());
  }

  private finish(): void {
    if (this.carried) this.dropCarried();
    else if (this.current()) this.drawing.finish();
  }

  private takeBack(): void {
    if (this.current()) this.drawing.takeBack();
    else this.removeChosen();
  }

  private escape(): void {
    if (this.carried) this.dropCarried();
    else if (this.store.now.cut) this.cutting.uncut();
    else if (this.current()) this.drawing.drop();
    else this.drawing.choose(null);
    this.cursor.hide();
  }

  private carry(): void {
    if (this.carried) this.dropCarried();
    else this.withPoint((point) => {
      this.carried = point;
      this.drawing.grip();
    });
  }

  private dropCarried(): void {
    if (!this.carried) return;
    this.carried = null;
    this.drawing.release();
  }

  private turn(event: KeyboardEvent): void {
    const [x, y] = turns[event.key.toLowerCase()];
    if (event.shiftKey) this.camera.pan(25 * x, 25 * y);
    else this.camera.orbit(25 * x, 25 * y);
    this.viewMoved();
  }

  private withPoint(act: (point: { curve: number; point: number }) => void): void {
    const { chosen } = this.store.now;
    if (chosen && chosen.point !== null) act({ curve: chosen.curve, point: chosen.point });
  }

  private current(): boolean {
    return this.drawing.current() !== null;
  }
}

function isText(target: EventTarget | null): boolean {
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement
    && !['range', 'checkbox', 'radio', 'button', 'file'].includes(target.type));
}
