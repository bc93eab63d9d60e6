// The pace of drawing: the time of the graphics card for the mesh, and whether the view moves.

/** Milliseconds; slower frames lag behind the mouse. */
const patience = 50;
/** Milliseconds without movement after which the view rests: `rest`, or the drawing time of the whole
   mesh if that is longer, but at most `longestRest`. */
const rest = 180, longestRest = 2000;

export class Pace {
  /** Whether drawing the whole mesh takes too long; false until measured. */
  isSlow = false;
  private movedAt = -Infinity;
  private timer = 0;
  private round = 0;
  private measured = 0;
  private took = 0;

  /** `onRest`: the view has come to rest. `again`: draws again. `onSlow`: drawing takes too long,
     with its time in ms. */
  constructor(private readonly onRest: () => void, private readonly again: () => void,
              private readonly onSlow: (took: number) => void) {}

  /** Another mesh: its drawing time is unknown. */
  reset(): void {
    ++this.round;
    this.measured = this.took = 0;
    this.isSlow = false;
  }

  moved(): void {
    this.movedAt = performance.now();
    this.settle();
  }

  /** Waits until the view rests. The wait becomes longer if a slower drawing time is measured
     meanwhile. */
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

  /** Measures the drawing that was just requested: the graphics card reports its end. */
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
    // The first drawing includes the transfer of the mesh to the graphics card.
    if (++this.measured === 1 && took > patience) {
      this.again();
      return;
    }
    this.took = took;
    this.isSlow = took > patience;
    if (this.isSlow && !was) this.onSlow(took);
  }
}
