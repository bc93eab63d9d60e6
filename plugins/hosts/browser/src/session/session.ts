// A session is the user's work: the mesh, the drawing, and the view. A value.
import type { CameraState } from '../view/camera';
import type { Opening, Show } from '../state/state';
import { packed, unpacked } from './bytes';

export interface Session {
  /** Without bytes only the drawing on the mesh is stored. `faces` distinguishes it from another
     mesh of the same name. */
  mesh: (Opening & { name: string; bytes: Uint8Array; faces?: number }) | null;
  /** The editor's state. */
  drawing: string;
  camera: CameraState;
  show: Show;
}

const format = 'talweg-session';

export async function sessionText(session: Session): Promise<string> {
  return textOf(session, session.mesh ? await packed(session.mesh.bytes) : '');
}

/** The session without the mesh's bytes, computed synchronously, since a page that is being left
   does not wait. */
export function drawingText(session: Session): string {
  return textOf(session, '');
}

/** The session with its mesh's bytes as packed() gives them. */
export function textOf({ mesh, ...others }: Session, bytes: string): string {
  return JSON.stringify({ format, version: 1, mesh: mesh ? { ...mesh, bytes } : null, ...others });
}

/** Throws Error with a sentence for text that is not a session. */
export async function sessionOf(name: string, text: string): Promise<Session> {
  let read: Record<string, unknown>;
  try {
    read = JSON.parse(text) as Record<string, unknown>;
  } catch {
    throw new Error(`${name} is not a session of Talweg: it is not JSON.`);
  }
  if (read.format !== format) throw new Error(`${name} is not a session of Talweg: its "format" is not "${format}".`);
  if (read.version !== 1) throw new Error(`${name} has version ${String(read.version)}; this page reads version 1.`);
  const { mesh, drawing, camera, show } = read as unknown as Omit<Session, 'mesh'> & {
    mesh: (Opening & { name: string; bytes: string; faces?: number }) | null;
  };
  try {
    return { mesh: mesh ? { ...mesh, bytes: await bytesOf(mesh.bytes) } : null, drawing, camera, show };
  } catch {
    throw new Error(`${name} is damaged: its mesh cannot be unpacked.`);
  }
}

async function bytesOf(text: string): Promise<Uint8Array> {
  return text ? unpacked(text) : new Uint8Array();
}
