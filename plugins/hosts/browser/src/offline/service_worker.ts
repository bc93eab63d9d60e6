// Keeps the page's own files in the browser, so that it works without a network. The user's files
// and drawings never come here.

/** Set by build.mjs: each file with its hash, and a hash of all. */
declare const FILES: Record<string, string>;
declare const VERSION: string;

interface Waiting extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface Asked extends Waiting {
  request: Request;
  respondWith(response: Promise<Response>): void;
}
interface WorkerSide {
  registration: { scope: string };
  clients: { claim(): Promise<void>; matchAll(options: object): Promise<unknown[]> };
  skipWaiting(): Promise<void>;
  addEventListener(name: 'install' | 'activate', task: (event: Waiting) => void): void;
  addEventListener(name: 'fetch', task: (event: Asked) => void): void;
  addEventListener(name: 'message', task: (event: MessageEvent & Waiting) => void): void;
}
const side = self as unknown as WorkerSide;
const { scope } = side.registration;
/** The cache's name has the page's address, since other pages of this host may keep files, too. */
const ours = `talweg ${scope} `, cacheName = ours + VERSION;

/** Keeps all files or none. A file with another hash is refused, as while a new version is being
   uploaded. */
async function keepAll(): Promise<void> {
  const cache = await caches.open(cacheName);
  await cache.addAll(Object.entries(FILES).map(([file, integrity]) =>
    new Request(new URL(file, scope), { integrity, cache: 'no-cache' })));
}

async function dropOthers(): Promise<void> {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(ours) && name !== cacheName)
    .map((name) => caches.delete(name)));
  await side.clients.claim();
}

async function kept(file: string, request: Request): Promise<Response> {
  const cache = await caches.open(cacheName);
  return (await cache.match(new URL(file, scope))) ?? fetch(request);
}

/** With two open pages, one would get files of another version. */
async function takeOver(): Promise<void> {
  const pages = await side.clients.matchAll({ type: 'window', includeUncontrolled: true });
  if (pages.length < 2) await side.skipWaiting();
}

side.addEventListener('install', (event) => event.waitUntil(keepAll()));
side.addEventListener('activate', (event) => event.waitUntil(dropOthers()));
side.addEventListener('message', (event) => event.waitUntil(takeOver()));
side.addEventListener('fetch', (event) => {
  const { method, url } = event.request;
  if (method !== 'GET' || !url.startsWith(scope)) return;
  const file = url.slice(scope.length).replace(/[?#].*$/s, '') || 'index.html';
  if (Object.hasOwn(FILES, file)) event.respondWith(kept(file, event.request));
});
