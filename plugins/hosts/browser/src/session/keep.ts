// Where sessions are kept: in this tab, and on this machine only after the person has said so.
// Drawings are small and kept often; a mesh is kept once.
import { packed, unpacked } from './bytes';
import * as database from './database';
import { isKeeper } from './keeper';
import { drawingText, sessionOf, textOf, type Session } from './session';

const drawingKey = 'talweg.session', meshKey = 'talweg.mesh', asidesKey = 'talweg.asides';
export const askedKey = 'talweg.keep';
/** What browsers let a tab keep, in characters, less some air. */
const tabRoom = 4_500_000;

/** The mesh that is to be kept, and the one that the tab has, or has no room for. */
let wanted: Uint8Array | null = null;
let keptInTab: Uint8Array | null = null;
let keptOnMachine: Uint8Array | null = null;
let asides: Session[] = [];
let last: Promise<unknown> = Promise.resolve();
/** What packed() made of these bytes. */
const texts = new WeakMap<Uint8Array, string>();

/** One after the other, so that what is being kept is forgotten, too. */
function inTurn<T>(work: () => Promise<T>): Promise<T> {
  const turn = last.then(work, work);
  last = turn;
  return turn;
}

/** Whether the person wants it: for all tabs. */
export function isKeptOnMachine(): boolean {
  return localStorage.getItem(askedKey) === 'yes';
}

function writesOnMachine(): boolean {
  return isKeptOnMachine() && isKeeper();
}

/** Says whether sessions are kept on this machine from now on; what is there is forgotten if not. */
export function keepOnMachine(keep: boolean): Promise<void> {
  return inTurn(async () => {
    keptOnMachine = null;
    if (keep) {
      localStorage.setItem(askedKey, 'yes');
      return;
    }
    localStorage.removeItem(askedKey);
    await database.drop();
  });
}

/** The tab has the drawing when this returns; whether the mesh is kept, too (a tab may lack the room), is told later. */
export async function keep(session: Session): Promise<boolean> {
  const bytes = session.mesh?.bytes ?? new Uint8Array();
  const drawing = drawingText(session);
  wanted = bytes;
  if (bytes !== keptInTab) sessionStorage.removeItem(meshKey);
  sessionStorage.setItem(drawingKey, drawing);
  return inTurn(() => keepWhole(bytes, drawing));
}

async function keepWhole(bytes: Uint8Array, drawing: string): Promise<boolean> {
  if (writesOnMachine()) {
    if (bytes !== keptOnMachine) await database.put('mesh', bytes);
    if (keptOnMachine === null) await database.put('asides', asides);
    keptOnMachine = bytes;
    await database.put('session', drawing);
  }
  if (bytes !== keptInTab) {
    keepAsideDrawings();  // the mesh that is open comes first
    await keepMeshInTab(bytes);
    await keepAsideMeshes();
  }
  return writesOnMachine() || sessionStorage.getItem(meshKey) !== null;
}

/** The tab has the drawings when this returns, and later their meshes, as far as there is room. */
export function keepAsides(sessions: Session[]): Promise<void> {
  asides = sessions;
  keepPackedAsides();
  return inTurn(async () => {
    if (writesOnMachine()) await database.put('asides', asides);
    await keepAsideMeshes();
  });
}

/** The session of this tab, or the one of this machine; without bytes if only the drawing is there. */
export async function kept(): Promise<Session | null> {
  const drawing = sessionStorage.getItem(drawingKey), mesh = sessionStorage.getItem(meshKey);
  if (drawing && mesh) {
    const bytes = await unpacked(mesh);
    texts.set(bytes, mesh);
    return withBytes(await read(drawing), bytes);
  }
  const onMachine = writesOnMachine() ? await keptOnThisMachine() : null;
  return onMachine ?? (drawing ? read(drawing) : null);
}

/** What the tab that keeps on this machine has kept last. */
export async function keptOnThisMachine(): Promise<Session | null> {
  const drawing = await database.get<string>('session');
  if (!drawing) return null;
  return withBytes(await read(drawing), (await database.get<Uint8Array>('mesh')) ?? new Uint8Array());
}

/** What was put aside, the newest first. */
export async function keptAsides(): Promise<Session[]> {
  const onMachine = writesOnMachine() ? await asidesOnThisMachine() : [];
  if (onMachine.length > 0) return onMachine;
  const all = JSON.parse(sessionStorage.getItem(asidesKey) ?? '[]') as { mesh: { bytes: string } | null }[];
  return Promise.all(all.map(async (one) => {
    const session = await read(JSON.stringify(one));
    if (session.mesh && one.mesh) texts.set(session.mesh.bytes, one.mesh.bytes);
    return session;
  }));
}

export async function asidesOnThisMachine(): Promise<Session[]> {
  return (await database.get<Session[]>('asides')) ?? [];
}

export function forgetAll(): Promise<void> {
  return inTurn(async () => {
    sessionStorage.clear();
    localStorage.clear();
    await database.drop();
  });
}

async function keepMeshInTab(bytes: Uint8Array): Promise<void> {
  sessionStorage.removeItem(meshKey);
  const text = await textOfBytes(bytes);
  if (bytes !== wanted) return;  // another one has come meanwhile
  keptInTab = bytes;
  if (text === null || text.length > tabRoom) return;
  try {
    sessionStorage.setItem(meshKey, text);
  } catch {
    // The browser gives less room than others do.
    sessionStorage.removeItem(meshKey);
  }
}

function keepAsideDrawings(): void {
  putAsides(asides.map(drawingText));
}

/** At once: with the meshes that are packed already, if they fit. */
function keepPackedAsides(): void {
  try {
    putAsides(asides.map((session) => textOf(session, (session.mesh && texts.get(session.mesh.bytes)) ?? '')));
  } catch {
    keepAsideDrawings();
  }
}

/** With the meshes of the newest, as far as there is room. */
async function keepAsideMeshes(): Promise<void> {
  const sessions = asides;
  let room = tabRoom - (sessionStorage.getItem(meshKey)?.length ?? 0);
  const all: string[] = [];
  for (const session of sessions) {
    const bytes = await textOfBytes(session.mesh?.bytes ?? new Uint8Array());
    const fits = bytes !== null && bytes.length <= room;
    if (fits) room -= bytes.length;
    all.push(fits ? textOf(session, bytes) : drawingText(session));
  }
  if (sessions !== asides) return;
  try {
    putAsides(all);
  } catch {
    keepAsideDrawings();
  }
}

function putAsides(all: string[]): void {
  if (all.length > 0) sessionStorage.setItem(asidesKey, `[${all.join(',')}]`);
  else sessionStorage.removeItem(asidesKey);
}

/** null for bytes that are too many for a tab. */
async function textOfBytes(bytes: Uint8Array): Promise<string | null> {
  // Packing halves at best what is no text: much larger ones need not be tried.
  if (bytes.length > 4 * tabRoom) return null;
  const text = texts.get(bytes) ?? (bytes.length > 0 ? await packed(bytes) : '');
  if (text.length <= tabRoom) texts.set(bytes, text);
  return text;
}

function read(text: string): Promise<Session> {
  return sessionOf('The session that was kept', text);
}

function withBytes(session: Session, bytes: Uint8Array): Session {
  return { ...session, mesh: session.mesh ? { ...session.mesh, bytes } : null };
}
