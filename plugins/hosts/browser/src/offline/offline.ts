// The page's side of its service worker, which makes it work without a net.
import { byId, setText } from '../elements';

/** How long a new version may take to begin before the old one goes on. */
const patience = 1000;

/**
 * A newer version that came during the last visit begins now, before anything is opened. Returns
 * whether the page is being loaded anew.
 */
export async function beginNewerVersion(): Promise<boolean> {
  const { serviceWorker } = navigator as Partial<Navigator>;
  const waiting = (await serviceWorker?.getRegistration().catch(() => undefined))?.waiting;
  if (!serviceWorker || !waiting) return false;
  const begins = new Promise<boolean>((resolve) => {
    serviceWorker.addEventListener('controllerchange', () => resolve(true), { once: true });
    setTimeout(() => resolve(false), patience);
  });
  waiting.postMessage('take over');
  if (!(await begins)) return false;
  location.reload();
  return true;
}

/** Keeps the page's files in the browser, and says so when they are there. */
export async function keepForOffline(): Promise<void> {
  const { serviceWorker } = navigator as Partial<Navigator>;
  // It is not there in http: from another machine, and may be off: then the page needs the net to open.
  if (!serviceWorker) return;
  try {
    await serviceWorker.register('service_worker.js');
    await serviceWorker.ready;
    setText('offline-told', 'This browser keeps the page itself: it opens without a net, too.');
    byId('offline-told').hidden = false;
  } catch {
    byId('offline-told').hidden = true;
  }
}
