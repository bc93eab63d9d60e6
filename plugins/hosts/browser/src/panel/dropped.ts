// The files that were dropped onto the page, also those in dropped folders.

/** A folder with more files was not dropped on purpose. */
const most = 1000;

/**
 * All files, and the names of the folders that they came from. Must be called at once: later the
 * browser hides the dropped items.
 */
export function droppedFiles(transfer: DataTransfer): Promise<{ files: File[]; folders: string[] }> {
  const items = [...transfer.items].filter((item) => item.kind === 'file');
  const entries = items.map((item) => item.webkitGetAsEntry());
  const plain = [...transfer.files];
  return collected(entries, plain);
}

async function collected(entries: (FileSystemEntry | null)[], plain: File[]) {
  const folders = entries.filter((entry) => entry?.isDirectory) as FileSystemDirectoryEntry[];
  const names = folders.map(({ name }) => name);
  const files = plain.filter((file) => !names.includes(file.name));
  for (const folder of folders) await addFiles(folder, files);
  return { files, folders: names };
}

async function addFiles(folder: FileSystemDirectoryEntry, files: File[]): Promise<void> {
  const reader = folder.createReader();
  for (;;) {
    // A browser returns some entries at a time, and none at the end.
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return;
    for (const entry of some) {
      if (files.length >= most) return;
      if (entry.isDirectory) await addFiles(entry as FileSystemDirectoryEntry, files);
      else files.push(await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject)));
    }
  }
}
