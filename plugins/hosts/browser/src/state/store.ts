// The store of the page's state. Data flow one way: the user's commands change the state, and the
// display is made from the state.
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

  /** Replaces these parts. Watchers are called once, after all current changes. */
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

  /** Sets or removes the sentence beside a part of the panel. */
  trouble(spot: Spot, sentence: string | null): void {
    const { [spot]: old, ...others } = this.state.trouble;
    if ((old ?? null) === sentence) return;
    this.set({ trouble: sentence === null ? others : { ...others, [spot]: sentence } });
  }

  /** New work removes the sentences about earlier work, except about storage. */
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

/** Whether one of these parts has changed. */
export function changed(now: State, before: State, ...parts: (keyof State)[]): boolean {
  return now === before || parts.some((part) => now[part] !== before[part]);
}
