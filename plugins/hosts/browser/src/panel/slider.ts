// A slider and a box with its number. A movement of the slider is one step of undo.

export interface Scale {
  /** The value at a position from 0 to 1, and the inverse. */
  value(position: number): number;
  position(value: number): number;
}

/** From 0 to 1. */
export const parts: Scale = { value: (t) => rounded(t), position: (v) => Math.min(1, Math.max(0, v)) };

/** Fine near 0: position t has the value most * t^2. */
export function squares(most: number): Scale {
  return {
    value: (t) => rounded(most * t * t),
    position: (v) => Math.sqrt(Math.min(1, Math.max(0, v) / most)),
  };
}

/** A logarithmic scale from least to most. */
export function factors(least: number, most: number): Scale {
  const all = Math.log(most / least);
  return {
    value: (t) => rounded(least * Math.exp(all * t)),
    position: (v) => Math.min(1, Math.max(0, Math.log(Math.max(v, least) / least) / all)),
  };
}

/** Three digits, the precision of a slider. */
function rounded(value: number): number {
  return Number(value.toPrecision(3));
}

export interface SliderHand {
  begin(): void;
  /** The slider is still held. */
  slide(value: number): void;
  end(): void;
  /** A number was typed. */
  write(value: number): void;
}

export class Slider {
  private sliding = false;

  constructor(private readonly range: HTMLInputElement, private readonly box: HTMLInputElement,
              private readonly scale: () => Scale, private readonly hand: SliderHand) {
    range.addEventListener('input', () => this.slid());
    range.addEventListener('change', () => this.ended());
    box.addEventListener('change', () => {
      if (Number.isFinite(box.valueAsNumber)) hand.write(box.valueAsNumber);
    });
  }

  show(value: number | null, text: string, enabled: boolean): void {
    this.range.disabled = this.box.disabled = !enabled;
    if (!this.sliding) this.range.value = String(value === null ? 0 : this.scale().position(value));
    this.range.setAttribute('aria-valuetext', text || 'automatic');
    if (document.activeElement !== this.box) this.box.value = text;
  }

  private slid(): void {
    if (!this.sliding) this.hand.begin();
    this.sliding = true;
    this.hand.slide(this.scale().value(Number(this.range.value)));
  }

  private ended(): void {
    if (!this.sliding) return;
    this.sliding = false;
    this.hand.end();
  }
}
