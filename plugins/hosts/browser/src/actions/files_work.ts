// Saves files: curves, cut meshes, pictures, reports. No data leave the machine.
import type { SavedFile } from '../engine/types';
import type { Stage } from '../view/stage';
import { nameOf } from '../state/state';
import { unitOf } from '../state/units';
import { curveTable } from './curve_table';
import type { Desk } from './desk';
import type { DrawingWork } from './drawing_work';

export class FilesWork {
  constructor(private readonly desk: Desk, private readonly drawing: DrawingWork,
              private readonly stage: Stage) {}

  async saveCurves(format: string): Promise<void> {
    await this.saveWhen(`Writing ${format}`, this.desk.engine.saveCurves(format));
  }

  async saveOffset(format: string): Promise<void> {
    await this.saveWhen(`Writing ${format}`, this.desk.engine.saveCurves(format.replace(/^drawn\./, ''), 'offset'));
  }

  async saveMesh(format: string): Promise<void> {
    await this.saveWhen(`Writing ${format}`, this.desk.engine.saveMesh(format));
  }

  /** A file for each part, one after the other: a browser may ask whether it may save several. */
  async saveParts(format: string): Promise<void> {
    const { engine, store } = this.desk;
    const parts = await this.desk.wait('files', `Writing ${format}`, engine.saveParts(format, store.now.lids));
    if (!parts) return;
    for (const part of parts) {
      save(part);
      await new Promise((done) => setTimeout(done, 150));
    }
    this.desk.tell(`Saved ${parts.length} ${parts.length === 1 ? 'file' : 'files'}.`);
  }

  async savePicture(): Promise<void> {
    const blob = await this.desk.wait('files', 'Making a picture', this.stage.picture());
    if (blob) download(`${this.stem()}.png`, blob);
  }

  saveReport(): void {
    const { smoothed } = this.desk.store.now;
    if (!smoothed) return;
    const unit = unitOf(this.desk.store.now);
    const report = { ...(unit && { unit }), ...JSON.parse(smoothed.report) as object };
    download(`${this.stem()}-report.json`, new Blob([JSON.stringify(report, null, 2)], { type: 'application/json' }));
  }

  async readCurves(file: File): Promise<void> {
    const work = file.arrayBuffer().then((bytes) => this.desk.engine.readCurves(file.name, bytes));
    const curves = await this.desk.wait('files', `Reading ${file.name}`, work);
    if (curves) this.drawing.addCurves(curves);
  }

  async copyTable(): Promise<void> {
    const { smoothed, drawing } = this.desk.store.now;
    if (!smoothed) return;
    const table = curveTable(smoothed.curves, drawing.curves.map(nameOf), unitOf(this.desk.store.now));
    await this.desk.wait('files', 'Copying the table', navigator.clipboard.writeText(table));
    this.desk.tell('Copied a row for each point of the curves.');
  }

  async copyCommand(): Promise<void> {
    await navigator.clipboard.writeText(this.command());
    this.desk.tell('Copied the command line.');
  }

  /** The command line; empty without a mesh. */
  command(): string {
    const { mesh, drawing: { offset }, offsets } = this.desk.store.now;
    return mesh ? this.desk.engine.command(offsets && offset.of === null ? offset : null) : '';
  }

  /** The mesh's name without its extensions. */
  stem(): string {
    const name = this.desk.store.now.mesh?.name ?? 'talweg';
    return name.replace(/\.gz$/i, '').replace(/\.[^.]*$/, '');
  }

  private async saveWhen(what: string, work: Promise<SavedFile>): Promise<void> {
    const file = await this.desk.wait('files', what, work);
    if (!file) return;
    save(file);
    this.desk.tell(`Saved ${file.name}.`);
  }
}

function save(file: SavedFile): void {
  download(file.name, new Blob([file.bytes as Uint8Array<ArrayBuffer>]));
}

export function download(name: string, blob: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The download has begun by then; a permanent address would keep the bytes in memory.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
