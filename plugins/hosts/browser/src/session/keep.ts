// Where sessions are kept: in this tab, and on this machine only after the person has said so.
// Drawings are small and kept often; a mesh is kept once.
import { packed, unpacked } from './bytes';
import * as database from './database';
import { drawingText, sessionOf, type Session } from './session';

const drawingKey = 'talweg.session', meshKey = 'talweg.mesh', askedKey = 'talweg.keep';
/** What browsers let a tab keep, in characters, less some air. */
const tabRoom = 4_500_000;

let keptInTab: Uint8Array | null = null;
let keptOnMachine: Uint8Array | null = null;
let last: Promise<unknown> = Promise.resolve();

/** One after the other, so that what is being kept is forgotten, too. */
function inTurn<T>(work: () => Promise<T>): Promise<T> {
  const turn = last.then(work, work);
  last = turn;
  return turn;
}

export function isKeptOnMachine(): boolean {
  return localStorage.getItem(askedKey) === 'yes';
}

/** Says whether sessions are kept on this machine from now on; what is there is forgotten if not. */
export function keepOnMachine(keep: boolean): Promise<void> {
  return inTurn(async () => {
    if (keep) {
      localStorage.setItem(askedKey, 'yes');
      return;
    }
    localStorage.removeItem(askedKey);
    keptOnMachine = null;
    await database.drop();
  });
}

/** The tab has the drawing when this returns; whether the mesh is kept, too (a tab may lack the room), is told later. */
export async function keep(session: Session): Promise<boolean> {
  const bytes = session.mesh?.bytes ?? new Uint8Array();
  const drawing = drawingText(session);
  if (bytes !== keptInTab) sessionStorage.removeItem(meshKey);
  sessionStorage.setItem(drawingKey, drawing);
  return inTurn(() => keepWhole(bytes, drawing));
}

async function keepWhole(bytes: Uint8Array, drawing: string): Promise<boolean> {
  if (isKeptOnMachine()) {
    if (bytes !== keptOnMachine) await database.put('mesh', bytes);
    keptOnMachine = bytes;
    await database.put('session', drawing);
  }
  if (bytes !== keptInTab) await keepMeshInTab(bytes);
  keptInTab = bytes;
  return isKeptOnMachine() || sessionStorage.getItem(meshKey) !== null;
}

/** The session of this tab, or the one of this machine; without bytes if only the drawing is there. */
export async function kept(): Promise<Session | null> {
  const drawing = sessionStorage.getItem(drawingKey), mesh = sessionStorage.getItem(meshKey);
  if (drawing && mesh) return withBytes(await read(drawing), await unpacked(mesh));
  const onMachine = isKeptOnMachine() ? await database.get<string>('session') : undefined;
  if (onMachine) {
    return withBytes(await read(onMachine), (await database.get<Uint8Array>('mesh')) ?? new Uint8Array());
  }
  return drawing ? read(drawing) : null;
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
  // Packing halves at best what is no text: much larger ones need not be tried.
  if (bytes.length > 4 * tabRoom) return;
  const text = await packed(bytes);
  if (text.length > tabRoom) return;
  try {
    sessionStorage.setItem(meshKey, text);
  } catch {
    // The browser gives less room than others do.
    sessionStorage.removeItem(meshKey);
  }
}

function read(text: string): Promise<Session> {
  return sessionOf('The session that was kept', text);
}

function withBytes(session: Session, bytes: Uint8Array): Session {
  return { ...session, mesh: session.mesh ? { ...session.mesh, bytes } : null };
}
