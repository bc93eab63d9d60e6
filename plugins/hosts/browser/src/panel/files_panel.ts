// Saves and reads files, and takes files that are dropped onto the page.
import { changed, type Store } from '../state/store';
import type { Desk } from '../actions/desk';
import type { FilesWork } from '../actions/files_work';
import type { MeshWork } from '../actions/mesh_work';
import type { SessionWork } from '../session/session_work';
import { chooseOne } from './choice';
import type { CutPanel } from './cut_panel';
import { droppedFiles } from './dropped';
import { type Acts, byId, chooseFile, enable, setText } from '../elements';

export const meshFiles = '.obj,.off,.ply,.stl,.om,.vtk,.vtp,.msh,.gltf,.glb,.3mf,.gii,'
  + '.white,.pial,.inflated,.sphere,.smoothwm,.orig,.mid,.midthickness,.graymid,.reg,.nofix,.gz';
const meshNames = 'OBJ, OFF, PLY, STL, OM, VTK, VTP, MSH, GLB, 3MF, GIFTI and FreeSurfer, also gzipped';
const curveFiles = '.json,.vtp,.vtk,.obj,.ply,.border,.fcsv,.txt';
export const sessionFiles = '.talweg';

export class FilesPanel {
  constructor(private readonly desk: Desk, store: Store, private readonly meshes: MeshWork,
              private readonly files: FilesWork, private readonly sessions: SessionWork,
              private readonly cuts: CutPanel) {
    const command = byId<HTMLDetailsElement>('command-details');
    const tell = () => {
      if (command.open) setText('command', this.files.command());
    };
    command.addEventListener('toggle', tell);
    store.watch((now, before) => {
      if (!changed(now, before, 'mesh', 'smoothed', 'offsets')) return;
      const hasCurves = now.smoothed !== null, hasMesh = now.mesh !== null;
      for (const act of ['save-curves', 'save-report', 'copy-table']) enable(act, hasCurves);
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
      'save-offset': () => files.saveOffset(format('curve-format')),
      'save-mesh': () => files.saveMesh(format('mesh-format')),
      'save-parts': () => files.saveParts(format('mesh-format')),
      'save-picture': () => files.savePicture(),
      'save-report': () => files.saveReport(),
      'save-session': () => sessions.saveFile(),
      'copy-table': () => files.copyTable(),
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
      if (!event.dataTransfer?.types.includes('Files')) return;
      event.preventDefault();
      const dropped = droppedFiles(event.dataTransfer);
      void this.desk.wait('mesh', 'Reading the dropped files', dropped).then((all) => all && this.take(all));
    });
  }

  /** Meshes first: curves and labels that come with a mesh belong on it. */
  private async take({ files, folders }: { files: File[]; folders: string[] }): Promise<void> {
    const kinds = await Promise.all(files.map(async (file) => ({ file, kind: await kindOf(file) })));
    const of = (kind: Kind) => kinds.filter((one) => one.kind === kind).map((one) => one.file);
    // A file with an unknown name is opened as a mesh, so that the library reports the error.
    const meshes = of('mesh').length > 0 || folders.length > 0 ? of('mesh') : of('other');
    // Folders contain many kinds of files: only meshes and sessions are used.
    if (folders.length > 0 && meshes.length + of('session').length === 0) {
      this.desk.store.trouble('mesh', `There is no mesh in ${folders.join(', ')}: this page opens ${meshNames}.`);
      return;
    }
    for (const file of of('session').slice(-1)) await this.sessions.openFile(file);
    if (meshes.length > 0 && !(await this.openOne(meshes))) return;
    if (folders.length > 0) return;
    for (const file of of('curves')) await this.files.readCurves(file);
    for (const file of of('labels')) await this.cuts.readLabels(file);
  }

  private async openOne(meshes: File[]): Promise<boolean> {
    const chosen = meshes.length === 1 ? 0
      : await chooseOne('One mesh can be open at a time. Which one?', meshes.map(({ name }) => name));
    return chosen !== null && this.meshes.openFile(meshes[chosen]);
  }
}

type Kind = 'mesh' | 'curves' | 'labels' | 'session' | 'other';

/** The kind of a file, by its name; OBJ, PLY and VTK files may hold meshes or curves. */
async function kindOf(file: File): Promise<Kind> {
  const name = file.name.toLowerCase();
  if (name.endsWith('.talweg')) return 'session';
  if (name.endsWith('.labels')) return 'labels';
  if (/\.(json|txt|csv|fcsv|border)$/.test(name)) return 'curves';
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
  return meshFiles.split(',').some((end) => name.endsWith(end)) ? 'mesh' : 'other';
}
