// The pace of drawing: how long the graphics card takes for the mesh, and whether the view moves.

/** Frames that take longer do not follow a hand. */
const patience = 50;
/** A view that has not moved for so long rests; where the whole mesh takes longer than that, for so long. */
const rest = 180, longestRest = 2000;

export class Pace {
  /** Whether drawing the whole mesh takes too long; false until this is known. */
  isSlow = false;
  private movedAt = -Infinity;
  private timer = 0;
  private round = 0;
  private measured = 0;
  private took = 0;

  /** `onRest`: the view has come to rest. `again`: draws anew. `onSlow`: drawing takes too long, and how long. */
  constructor(private readonly onRest: () => void, private readonly again: () => void,
              private readonly onSlow: (took: number) => void) {}

  /** Another mesh: nothing is known of it. */
  reset(): void {
    ++this.round;
    this.measured = this.took = 0;
    this.isSlow = false;
  }

  moved(): void {
    this.movedAt = performance.now();
    this.settle();
  }

  /** Waits until the view rests. The wait becomes longer where drawing turns out to be slower meanwhile. */
  private settle(): void {
    clearTimeout(this.timer);
    const left = this.movedAt + this.rest - performance.now();
    if (left > 0) this.timer = window.setTimeout(() => this.settle(), left);
    else this.onRest();
  }

  get moves(): boolean {
    return performance.now() - this.movedAt < this.rest;
  }

  private get rest(): number {
    return Math.min(longestRest, Math.max(rest, this.took));
  }

  /** Measures what has just been asked of the card: it tells when it is done. */
  measure(context: WebGL2RenderingContext): void {
    const round = this.round, began = performance.now();
    const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    context.flush();
    const look = () => {
      const took = performance.now() - began;
      const done = context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED;
      if (!done && took < 10_000 && !context.isContextLost()) {
        setTimeout(look, 5);
        return;
      }
      context.deleteSync(fence);
      if (round === this.round) this.take(took);
    };
    setTimeout(look, 5);
  }

  private take(took: number): void {
    const was = this.isSlow;
    // The first time the card gets the mesh, too, which it has from then on.
    if (++this.measured === 1 && took > patience) {
      this.again();
      return;
    }
    this.took = took;
    this.isSlow = took > patience;
    if (this.isSlow && !was) this.onSlow(took);
  }
}
