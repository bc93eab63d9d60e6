// A ball with bumps as arrays, as three.js, vtk.js and files have them: three numbers for each vertex, three
// vertices for each triangle.
export function ball(rings = 40) {
  const around = 2 * rings, positions = [0, 0, 1], indices = [];
  for (let i = 1; i < rings; ++i) {
    for (let j = 0; j < around; ++j) {
      const t = (Math.PI * i) / rings, p = (2 * Math.PI * j) / around;
      const r = 1 + 0.06 * Math.sin(3 * t) * Math.cos(4 * p);
      positions.push(r * Math.sin(t) * Math.cos(p), r * Math.sin(t) * Math.sin(p), r * Math.cos(t));
    }
  }
  positions.push(0, 0, -1);
  const last = positions.length / 3 - 1;
  const id = (i, j) => (i === 0 ? 0 : i === rings ? last : 1 + (i - 1) * around + (j % around));
  for (let i = 0; i < rings; ++i) {
    for (let j = 0; j < around; ++j) {
      if (i < rings - 1) indices.push(id(i, j), id(i + 1, j), id(i + 1, j + 1));
      if (i > 0) indices.push(id(i, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}
