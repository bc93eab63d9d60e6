// The npm package `talweg`: the page's engine on meshes given as arrays.
import type { Module } from '../engine/module.js';
import type { MeshInfo } from '../engine/types.js';
import { newModule } from './load.js';
import { Mesh } from './mesh.js';
import { plyOf } from './ply.js';
import { TalwegError, talwegError } from './talweg_error.js';

export type { Drawn, Options, Place } from './drawing.js';
export type { ErrorKind } from './talweg_error.js';
export type {
  Caps, CurveReport, CutResult, Decisive, Ends, Line, Offset, RidgeKind, RidgeReport, SavedFile, Settings, Side,
  Smoothed, Vec3,
} from '../engine/types.js';
export type { Mesh };
export { TalwegError };

/** The engine of a mesh that was disposed of serves the next mesh, since its memory cannot be given back. */
let idle: Module | null = null;

function keep(module: Module): void { idle ??= module; }

/**
 * Opens a mesh of `positions`, three numbers for each vertex, and `indices`, three vertices from 0 for each
 * triangle, counterclockwise seen from outside. Both are copied. `repair` repairs a mesh on which curves cannot
 * be drawn otherwise; faces keep their indices. Throws TalwegError for arrays that are not a mesh, and for a mesh
 * with defects.
 */
export async function openMesh(
  positions: ArrayLike<number>, indices: ArrayLike<number>, { repair = false }: { repair?: boolean } = {},
): Promise<Mesh> {
  const bytes = plyOf(positions, indices);
  const corners = Uint32Array.from(indices);
  const module = idle ?? (await newModule());
  if (module === idle) idle = null;
  let info: MeshInfo;
  try {
    info = module.call<MeshInfo>('open', ['mesh.ply', Boolean(repair), null], bytes);
  } catch (error) {
    const told = talwegError(error);
    if (told.kind !== 'internal') keep(module);
    throw told;
  }
  if (info.defects === null) {
    return new Mesh(module, keep, info.vertices, info.faces, corners, info.repaired?.changes ?? []);
  }
  keep(module);
  throw new TalwegError(info.defects, 'mesh');
}
