// The browser's database on this machine: a few values by name.
const name = 'talweg';

export async function put(key: string, value: unknown): Promise<void> {
  await inDatabase('readwrite', (values) => values.put(value, key));
}

export async function get<T>(key: string): Promise<T | undefined> {
  return (await inDatabase('readonly', (values) => values.get(key))) as T | undefined;
}

/** Removes the database; if another tab has it open, when that tab closes it. */
export function drop(): Promise<void> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.deleteDatabase(name);
    request.onsuccess = () => resolve();
    request.onerror = () => reject(new Error('The session stored on this device could not be removed.'));
  });
}

function inDatabase(mode: IDBTransactionMode, act: (values: IDBObjectStore) => { readonly result: unknown }) {
  return new Promise<unknown>((resolve, reject) => {
    const opening = indexedDB.open(name, 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore('values');
    opening.onerror = () => reject(new Error('This browser cannot store data on this device.'));
    opening.onsuccess = () => {
      const transaction = opening.result.transaction('values', mode);
      const request = act(transaction.objectStore('values'));
      transaction.oncomplete = () => {
        opening.result.close();
        resolve(request.result);
      };
      transaction.onabort = () => {
        opening.result.close();
        reject(new Error(`The session could not be kept on this device: ${String(transaction.error?.message)}`));
      };
    };
  });
}
