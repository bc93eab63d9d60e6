import { EngineError } from '../engine/module.js';

/**
 * The subject of an error: `usage` a wrong argument, `mesh` a mesh that is not a surface to draw on, `curve` a
 * curve that does not lie on it or is invalid, `file` a file that cannot be written or talweg.wasm that
 * cannot be loaded, `numerical` an equation that could not be solved, `memory` too little memory, `internal`
 * a fault of the library.
 */
export type ErrorKind = 'usage' | 'mesh' | 'curve' | 'file' | 'numerical' | 'memory' | 'internal';

/** By talweg_status (plugins/interface/talweg_plugin.h); the others do not come from this engine. */
const kinds: ErrorKind[] = ['internal', 'usage', 'mesh', 'curve', 'file', 'numerical', 'memory'];

/** Input that cannot be used, or a failure; the message is a sentence for people. */
export class TalwegError extends Error {
  override readonly name = 'TalwegError';

  constructor(sentence: string, readonly kind: ErrorKind) { super(sentence); }
}

/** Any error of the engine as a TalwegError. An error that the engine did not tell has ended the engine. */
export function talwegError(error: unknown): TalwegError {
  if (error instanceof TalwegError) return error;
  if (error instanceof EngineError) return new TalwegError(error.message, kinds[error.status] ?? 'internal');
  return new TalwegError(`The engine failed (${String(error)}): open the mesh again.`, 'internal');
}
