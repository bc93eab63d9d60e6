// The page's part of its service worker, which makes the page work without a network.
import { byId, setText } from '../elements';

/** Milliseconds within which a new version must start; otherwise the old version continues. */
const patience = 1000;

/**
 * Starts a newer version that arrived during the last visit, before anything is opened. Returns
 * whether the page is being reloaded.
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

/** Keeps the page's files in the browser, and shows when they are complete. */
export async function keepForOffline(): Promise<void> {
  const { serviceWorker } = navigator as Partial<Navigator>;
  // Browsers have no service worker for http: from another machine, and may switch it off; the page
  // then needs the network.
  if (!serviceWorker) return;
  try {
    await serviceWorker.register('service_worker.js');
    await serviceWorker.ready;
    setText('offline-told', 'This browser has stored the page, which now opens without a network, too.');
    byId('offline-told').hidden = false;
  } catch {
    byId('offline-told').hidden = true;
  }
}
