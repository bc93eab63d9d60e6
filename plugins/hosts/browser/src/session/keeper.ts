// Of several tabs only one keeps its session on this machine: the first that wanted to. Another one
// gets its turn when that tab is closed.

const name = 'talweg.machine';
/** A tab that is loaded anew may have to wait for itself. */
const patience = 500;

let letGo: (() => void) | null = null;
let queue: AbortController | null = null;

/** Whether this tab may write what is kept on the machine. */
export function isKeeper(): boolean {
  return letGo !== null || !hasLocks();
}

/** Whether this tab has become the keeper; if not, `later` is called when it has. */
export async function becomeKeeper(later: () => void): Promise<boolean> {
  if (isKeeper() || (await locked(AbortSignal.timeout(patience)))) return true;
  if (!queue) {
    queue = new AbortController();
    void locked(queue.signal).then((mine) => {
      queue = null;
      if (mine) later();
    });
  }
  return false;
}

export function stopKeeping(): void {
  queue?.abort();
  letGo?.();
  letGo = null;
}

/** Browsers lock only on pages from https: and this machine. */
function hasLocks(): boolean {
  return (navigator as Partial<Navigator>).locks !== undefined;
}

/** Holds the lock until stopKeeping() or the end of the page. */
function locked(signal: AbortSignal): Promise<boolean> {
  return new Promise((resolve) => {
    navigator.locks.request(name, { signal }, () => new Promise<void>((done) => {
      letGo = done;
      resolve(true);
    })).catch(() => resolve(false));
  });
}
