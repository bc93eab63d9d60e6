// The one place where the page's state is kept. Data flows one way: what a person does changes the
// state, and everything that is seen is made from the state.
import { firstState, type Spot, type State } from './state';

type Watcher = (now: State, before: State) => void;

export class Store {
  private state = firstState;
  private told = firstState;
  private watchers: Watcher[] = [];
  private scheduled = false;

  get now(): State {
    return this.state;
  }

  /** Replaces these parts. Watchers hear of it once, when everything at hand is done. */
  set(parts: Partial<State>): void {
    this.state = { ...this.state, ...parts };
    if (this.scheduled) return;
    this.scheduled = true;
    queueMicrotask(() => this.tell());
  }

  watch(watcher: Watcher): void {
    this.watchers.push(watcher);
    watcher(this.state, this.state);
  }

  /** Puts a sentence beside a part of the panel, or takes it away. */
  trouble(spot: Spot, sentence: string | null): void {
    const { [spot]: old, ...others } = this.state.trouble;
    if ((old ?? null) === sentence) return;
    this.set({ trouble: sentence === null ? others : { ...others, [spot]: sentence } });
  }

  /** Work goes on: what was told before is over, but for what cannot be kept. */
  goOn(): void {
    const { session } = this.state.trouble;
    if (Object.keys(this.state.trouble).some((spot) => spot !== 'session')) {
      this.set({ trouble: session === undefined ? {} : { session } });
    }
  }

  private tell(): void {
    this.scheduled = false;
    const before = this.told;
    this.told = this.state;
    for (const watcher of this.watchers) watcher(this.told, before);
  }
}

/** Whether one of these parts is another than before. */
export function changed(now: State, before: State, ...parts: (keyof State)[]): boolean {
  return now === before || parts.some((part) => now[part] !== before[part]);
}
