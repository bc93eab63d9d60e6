// Stores sessions: in this tab, and on this machine only with the user's consent. Drawings are
// small and stored often; a mesh is stored once.
import { packed, unpacked } from './bytes';
import * as database from './database';
import { isKeeper } from './keeper';
import { drawingText, sessionOf, textOf, type Session } from './session';

const drawingKey = 'talweg.session', meshKey = 'talweg.mesh', asidesKey = 'talweg.asides';
export const askedKey = 'talweg.keep';
/** The storage of a tab in browsers, in characters, with a margin. */
const tabRoom = 4_500_000;

/** The mesh to be stored, and the mesh that the tab has or has no room for. */
let wanted: Uint8Array | null = null;
let keptInTab: Uint8Array | null = null;
let keptOnMachine: Uint8Array | null = null;
let asides: Session[] = [];
let last: Promise<unknown> = Promise.resolve();
/** The results of packed() for bytes. */
const texts = new WeakMap<Uint8Array, string>();

/** Runs work in sequence, so that data that are being stored are also removed. */
function inTurn<T>(work: () => Promise<T>): Promise<T> {
  const turn = last.then(work, work);
  last = turn;
  return turn;
}

/** Whether the user wants storage on the machine; holds for all tabs. */
export function isKeptOnMachine(): boolean {
  return localStorage.getItem(askedKey) === 'yes';
}

function writesOnMachine(): boolean {
  return isKeptOnMachine() && isKeeper();
}

/** Switches storage on this machine on or off; off removes all stored data. */
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

/** The drawing is stored when this returns. The promise tells whether the mesh is stored, too; a
   tab may lack the room. */
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
    keepAsideDrawings();  // the open mesh has priority
    await keepMeshInTab(bytes);
    await keepAsideMeshes();
  }
  return writesOnMachine() || sessionStorage.getItem(meshKey) !== null;
}

/** The drawings are stored when this returns, and later their meshes, as far as there is room. */
export function keepAsides(sessions: Session[]): Promise<void> {
  asides = sessions;
  keepPackedAsides();
  return inTurn(async () => {
    if (writesOnMachine()) await database.put('asides', asides);
    await keepAsideMeshes();
  });
}

/** The session of this tab, or of this machine; without bytes if only the drawing is stored. */
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

/** The last session that a tab stored on this machine. */
export async function keptOnThisMachine(): Promise<Session | null> {
  const drawing = await database.get<string>('session');
  if (!drawing) return null;
  return withBytes(await read(drawing), (await database.get<Uint8Array>('mesh')) ?? new Uint8Array());
}

/** The drawings that were put aside, the newest first. */
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
  if (bytes !== wanted) return;  // another mesh has been opened since
  keptInTab = bytes;
  if (text === null || text.length > tabRoom) return;
  try {
    sessionStorage.setItem(meshKey, text);
  } catch {
    // This browser has less room than others.
    sessionStorage.removeItem(meshKey);
  }
}

function keepAsideDrawings(): void {
  putAsides(asides.map(drawingText));
}

/** Stores at once the drawings, with the meshes that are already packed, if they fit. */
function keepPackedAsides(): void {
  try {
    putAsides(asides.map((session) => textOf(session, (session.mesh && texts.get(session.mesh.bytes)) ?? '')));
  } catch {
    keepAsideDrawings();
  }
}

/** Stores the drawings, with the meshes of the newest, as far as there is room. */
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

/** The packed text; null for bytes that are too many for a tab. */
async function textOfBytes(bytes: Uint8Array): Promise<string | null> {
  // Packing saves at most half of binary data: much larger data cannot fit.
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
