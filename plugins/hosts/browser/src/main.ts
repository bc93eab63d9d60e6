// Connects the page's parts: the store, hands and panel that change it, and the view that shows it.
import { Cursor } from './gestures/cursor';
import { Hand } from './gestures/hand';
import { Keys } from './gestures/keys';
import { Pointers } from './gestures/pointers';
import { Finder } from './gestures/under';
import { beginNewerVersion, keepForOffline } from './offline/offline';
import { bindAsidePanel } from './panel/aside_panel';
import { CurvePanel } from './panel/curve_panel';
import { CutPanel } from './panel/cut_panel';
import { FilesPanel } from './panel/files_panel';
import { forgetActs } from './panel/forget_panel';
import { bindHelp } from './panel/help';
import { bindHint } from './panel/hint';
import { bindMeshPanel } from './panel/mesh_panel';
import { bindActs, byId, input, numberIn } from './elements';
import { OffsetPanel } from './panel/offset_panel';
import { bindReportPanel } from './panel/report_panel';
import { SettingsPanel } from './panel/settings_panel';
import { bindShowPanel, worstOf } from './panel/show_panel';
import { bindTrouble } from './panel/trouble';
import { Asides } from './session/asides';
import { Current } from './session/current';
import { SessionWork } from './session/session_work';
import { Store } from './state/store';
import { firstVerdict } from './state/verdict';
import { Stage } from './view/stage';
import { View } from './view/view';
import { CutWork } from './actions/cut_work';
import { Desk, sentenceOf } from './actions/desk';
import { DrawingWork } from './actions/drawing_work';
import { FilesWork } from './actions/files_work';
import { Live } from './actions/live';
import { MeshWork } from './actions/mesh_work';
import { OffsetWork } from './actions/offset_work';

async function start(store: Store): Promise<void> {
  if (await beginNewerVersion()) return;
  const box = byId('view');
  const stage = new Stage(box, byId<HTMLCanvasElement>('canvas'));
  const view = new View(stage, byId('marks'), store);
  const desk = await Desk.start(store);

  const live = new Live(desk);
  const drawing = new DrawingWork(desk, live);
  const meshes = new MeshWork(desk, live, (ready) => view.showMesh(ready), () => stage.camera.lookAslant());
  const cutting = new CutWork(desk, drawing);
  const files = new FilesWork(desk, drawing, stage);
  const current = new Current(desk, live, meshes, stage.camera);
  const asides = new Asides(desk, current, meshes);
  const sessions = new SessionWork(desk, store, current, asides);
  bindAsidePanel(store, (id) => asides.bringBack(id));

  const viewMoved = () => stage.ask();
  const finder = new Finder(stage, () => meshes.picker);
  const hand = new Hand(store, finder, drawing, live, cutting, (touch) => view.partAt(touch.x, touch.y));
  new Pointers(box, stage.camera, hand, viewMoved);
  const cursor = new Cursor(store, stage, finder);
  const keys = new Keys(box, store, stage.camera, cursor, hand, drawing, live, cutting, viewMoved);
  keys.all.push({ keys: ['?'], shown: '?', what: 'this list', act: () => help() });
  const help = bindHelp(keys.all);

  const curves = new CurvePanel(store, drawing);
  const cuts = new CutPanel(store, cutting);
  new SettingsPanel(store, drawing);
  new OffsetPanel(store, new OffsetWork(desk, live));
  bindShowPanel(store, live);
  const filesPanel = new FilesPanel(desk, store, meshes, files, sessions, cuts);
  bindActs({
    ...curves.acts(), ...cuts.acts(), ...filesPanel.acts(),
    sample: () => meshes.openSample(),
    repair: () => meshes.repair(numberIn(input('weld'))),
    end: () => meshes.endWork(),
    undo: () => drawing.undo(),
    redo: () => drawing.redo(),
    finish: () => drawing.finish(),
    close: () => drawing.close(),
    'take-back': () => drawing.takeBack(),
    drop: () => drawing.drop(),
    pin: () => keys.pinChosen(),
    'remove-point': () => keys.removeChosen(),
    fit: () => {
      stage.camera.fit();
      viewMoved();
    },
    'go-worst': () => {
      const worst = worstOf(store.now);
      if (!worst) return;
      store.set({ show: { ...store.now.show, worst: true } });
      view.goTo(worst);
    },
    'go-alert': () => {
      const place = firstVerdict(store.now)?.decisive.find((one) => one.at)?.at;
      if (place) view.goTo(place);
    },
    help,
    ...forgetActs(() => sessions.forget()),
  });
  const unit = byId<HTMLSelectElement>('mesh-unit');
  unit.addEventListener('change', () => void meshes.setUnit(unit.value));
  const all = byId<HTMLDetailsElement>('mesh-all');
  all.addEventListener('toggle', () => {
    meshes.wantsAll = all.open;
    void meshes.tellAll();
  });
  await meshes.loaded();
  await sessions.bringBack();
  document.documentElement.dataset.ready = 'yes';
  await keepForOffline();
}

const store = new Store();
bindMeshPanel(store);
bindReportPanel(store);
bindHint(store);
bindTrouble(store);
start(store).catch((error: unknown) => {
  store.trouble('mesh', `The page cannot work here: ${sentenceOf(error)}`);
  byId('start').hidden = true;
  for (const button of document.querySelectorAll<HTMLButtonElement>('[data-act]')) button.disabled = true;
});
