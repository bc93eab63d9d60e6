// Saving, reading, and what is dropped onto the page.
import { changed, type Store } from '../state/store';
import type { Desk } from '../actions/desk';
import type { FilesWork } from '../actions/files_work';
import type { MeshWork } from '../actions/mesh_work';
import type { SessionWork } from '../session/session_work';
import type { CutPanel } from './cut_panel';
import { type Acts, byId, chooseFile, enable, setText } from '../elements';

export const meshFiles = '.obj,.off,.ply,.stl,.om,.vtk,.vtp,.msh,.gltf,.glb,.3mf,.gz';
const curveFiles = '.json,.vtp,.vtk,.obj,.ply,.txt';
export const sessionFiles = '.talweg';

export class FilesPanel {
  constructor(private readonly desk: Desk, store: Store, private readonly meshes: MeshWork,
              private readonly files: FilesWork, private readonly sessions: SessionWork,
              private readonly cuts: CutPanel) {
    const command = byId<HTMLDetailsElement>('command-details');
    const tell = () => {
      if (command.open) setText('command', store.now.mesh ? this.desk.engine.command() : '');
    };
    command.addEventListener('toggle', tell);
    store.watch((now, before) => {
      if (!changed(now, before, 'mesh', 'smoothed')) return;
      const hasCurves = now.smoothed !== null, hasMesh = now.mesh !== null;
      for (const act of ['save-curves', 'save-report']) enable(act, hasCurves);
      for (const act of ['save-picture', 'choose-curves', 'save-session']) enable(act, hasMesh);
      tell();
    });
    this.bindDrop();
  }

  acts(): Acts {
    const { files, meshes, sessions } = this;
    const format = (id: string) => byId<HTMLSelectElement>(id).value;
    return {
      'choose-mesh': () => chooseFile(meshFiles, (file) => void meshes.openFile(file)),
      'choose-curves': () => chooseFile(curveFiles, (file) => void files.readCurves(file)),
      'choose-session': () => chooseFile(sessionFiles, (file) => void sessions.openFile(file)),
      'save-curves': () => files.saveCurves(format('curve-format')),
      'save-mesh': () => files.saveMesh(format('mesh-format')),
      'save-picture': () => files.savePicture(),
      'save-report': () => files.saveReport(),
      'save-session': () => sessions.saveFile(),
      'copy-command': () => files.copyCommand(),
    };
  }

  private bindDrop(): void {
    const veil = byId('drop-here');
    addEventListener('dragover', (event) => {
      if (!event.dataTransfer?.types.includes('Files')) return;
      event.preventDefault();
      veil.hidden = false;
    });
    addEventListener('dragleave', (event) => (veil.hidden = event.relatedTarget === null || veil.hidden));
    addEventListener('drop', (event) => {
      veil.hidden = true;
      const all = event.dataTransfer?.files;
      if (!all?.length) return;
      event.preventDefault();
      void this.take([...all]);
    });
  }

  /** Meshes first: curves and labels that come with one belong on it. */
  private async take(all: File[]): Promise<void> {
    const kinds = await Promise.all(all.map(async (file) => ({ file, kind: await kindOf(file) })));
    const of = (kind: Kind) => kinds.filter((one) => one.kind === kind).map((one) => one.file);
    for (const file of of('session')) await this.sessions.openFile(file);
    for (const file of of('mesh')) await this.meshes.openFile(file);
    for (const file of of('curves')) await this.files.readCurves(file);
    for (const file of of('labels')) await this.cuts.readLabels(file);
  }
}

type Kind = 'mesh' | 'curves' | 'labels' | 'session';

/** What a file is, by its name; OBJ, PLY and VTK files may hold either. */
async function kindOf(file: File): Promise<Kind> {
  const name = file.name.toLowerCase();
  if (name.endsWith('.talweg')) return 'session';
  if (name.endsWith('.labels')) return 'labels';
  if (/\.(json|txt|csv)$/.test(name)) return 'curves';
  if (name.endsWith('.vtp')) {
    return /NumberOf(Polys|Strips)="0*[1-9]/.test(await file.text()) ? 'mesh' : 'curves';
  }
  if (name.endsWith('.vtk')) {
    return /^(POLYGONS|TRIANGLE_STRIPS|CELLS) /m.test(await file.text()) ? 'mesh' : 'curves';
  }
  if (name.endsWith('.obj')) return /^f\s/m.test(await file.text()) ? 'mesh' : 'curves';
  if (name.endsWith('.ply')) {
    const head = await file.slice(0, 4096).text();
    return /element face (?!0\s)/.test(head) ? 'mesh' : 'curves';
  }
  return 'mesh';
}
