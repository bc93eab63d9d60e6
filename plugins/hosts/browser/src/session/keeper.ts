// Of several tabs only one, the first that asked, stores its session on this machine. When it is
// closed, another tab follows.

const name = 'talweg.machine';
/** Milliseconds; a reloaded tab may have to wait for the release of its own lock. */
const patience = 500;

let letGo: (() => void) | null = null;
let queue: AbortController | null = null;

/** Whether this tab may write to the storage of the machine. */
export function isKeeper(): boolean {
  return letGo !== null || !hasLocks();
}

/** Whether this tab has become the keeper; if not, `later` is called when it becomes the keeper. */
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

/** Browsers have locks only for pages from https: and from this machine. */
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
