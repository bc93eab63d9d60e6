// A mesh of arrays goes to the engine as a PLY file, which is read like any other.
import { TalwegError } from './talweg_error.js';

const vertexBytes = 24, faceBytes = 13;

/** The length of an array, or of another list of numbers. */
export function lengthOf(name: string, numbers: ArrayLike<number>): number {
  const length: unknown = (numbers as ArrayLike<number> | null | undefined)?.length;
  if (typeof numbers === 'object' && typeof length === 'number') return length;
  throw new TalwegError(`The ${name} are not an array: give a typed array, or an array of numbers.`, 'usage');
}

function count(name: string, numbers: ArrayLike<number>, of: string): number {
  const length = lengthOf(name, numbers);
  if (length > 0 && length % 3 === 0) return length / 3;
  throw new TalwegError(`There are ${length} ${name}: give three for each ${of}, and at least one ${of}.`, 'usage');
}

function writePositions(view: DataView, at: number, positions: ArrayLike<number>): void {
  for (let k = 0; k < positions.length; ++k) {
    const x: unknown = positions[k];
    if (typeof x !== 'number' || !Number.isFinite(x)) {
      throw new TalwegError(`Coordinate ${k % 3} of vertex ${Math.floor(k / 3)} is ${String(x)}: give finite numbers.`, 'mesh');
    }
    view.setFloat64(at + 8 * k, x, true);
  }
}

function writeFaces(view: DataView, at: number, indices: ArrayLike<number>, vertices: number): void {
  for (let k = 0; k < indices.length; ++k) {
    const vertex: unknown = indices[k];
    if (!(Number.isInteger(vertex) && (vertex as number) >= 0 && (vertex as number) < vertices)) {
      throw new TalwegError(`Corner ${k % 3} of face ${Math.floor(k / 3)} is ${String(vertex)}: `
        + `vertices are counted from 0 to ${vertices - 1}.`, 'mesh');
    }
    const face = at + faceBytes * Math.floor(k / 3);
    view.setUint8(face, 3);
    view.setUint32(face + 1 + 4 * (k % 3), vertex as number, true);
  }
}

/** A binary PLY file with vertices as doubles. Throws TalwegError for arrays that are not a mesh. */
export function plyOf(positions: ArrayLike<number>, indices: ArrayLike<number>): Uint8Array {
  const vertices = count('positions', positions, 'vertex'), faces = count('indices', indices, 'triangle');
  const header = new TextEncoder().encode('ply\nformat binary_little_endian 1.0\n'
    + `element vertex ${vertices}\nproperty double x\nproperty double y\nproperty double z\n`
    + `element face ${faces}\nproperty list uchar uint vertex_indices\nend_header\n`);
  const bytes = new Uint8Array(header.length + vertexBytes * vertices + faceBytes * faces);
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  writePositions(view, header.length, positions);
  writeFaces(view, header.length + vertexBytes * vertices, indices, vertices);
  return bytes;
}
