// The part of times.mjs that runs in the browser.
import make from './talweg.js';

async function engine() {
  const kinds = [Float64Array, Float32Array, Uint32Array, Int32Array, Uint8Array];
  const talweg = await make();
  const text = (string) => {
    const room = talweg.lengthBytesUTF8(string) + 1, at = talweg._malloc(room);
    talweg.stringToUTF8(string, at, room);
    return at;
  };
  const revived = (_key, value) => {
    if (value === null || typeof value !== 'object' || !('$array' in value)) return value;
    const k = value.$array;
    return new kinds[talweg._talweg_array_kind(k)](talweg.HEAPU8.buffer, talweg._talweg_array_data(k),
      talweg._talweg_array_count(k)).slice();
  };
  const call = (name, args = [], bytes = undefined) => {
    if (bytes) {
      const at = talweg._talweg_room(bytes.length);
      talweg.HEAPU8.set(bytes, at);
    }
    const given = [text(name), text(JSON.stringify(args))];
    const reply = JSON.parse(talweg.UTF8ToString(talweg._talweg_call(...given)), revived);
    given.forEach((at) => talweg._free(at));
    if ('error' in reply) throw new Error(reply.error);
    return reply.answer;
  };
  return { call, memory: () => Math.round(talweg.HEAPU8.length / 2 ** 20) };
}

/** Faces in breadth-first order from a face, across edges. */
function around(triangles, from, count) {
  const faces = triangles.length / 3, at = new Map();
  for (let f = 0; f < faces; ++f) {
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [triangles[3 * f + k], triangles[3 * f + ((k + 1) % 3)]];
      at.set(a * faces + b, f);
    }
  }
  const met = [from], seen = new Set(met);
  for (let i = 0; i < met.length && met.length < count; ++i) {
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [triangles[3 * met[i] + k], triangles[3 * met[i] + ((k + 1) % 3)]];
      const next = at.get(b * faces + a);
      if (next === undefined || seen.has(next)) continue;
      seen.add(next);
      met.push(next);
    }
  }
  return met;
}

function centre({ triangles, positions }, f) {
  return [0, 1, 2].map((i) => [0, 1, 2].reduce((sum, k) => sum + positions[3 * triangles[3 * f + k] + i] / 3, 0));
}

/** Four of these faces that are far from each other. */
function apart(info, faces) {
  const distance = (f, g) => Math.hypot(...centre(info, f).map((x, i) => x - centre(info, g)[i]));
  const far = (from) => faces.reduce((best, f) => (distance(f, from) > distance(best, from) ? f : best), faces[0]);
  const a = faces[0], c = far(a);
  const between = [...faces].sort((f, g) =>
    Math.abs(distance(f, a) - distance(f, c)) - Math.abs(distance(g, a) - distance(g, c)));
  const b = between[0];
  const d = between.slice(0, 20).reduce((best, f) => (distance(f, b) > distance(best, b) ? f : best), b);
  return [a, b, c, d];
}

export async function times(name) {
  const bytes = new Uint8Array(await (await fetch(`./${name}`)).arrayBuffer());
  const { call, memory } = await engine();
  const rows = [];
  const took = (what, count, work) => {
    const all = [];
    for (let k = 0; k < count; ++k) {
      const began = performance.now();
      work(k);
      all.push(performance.now() - began);
    }
    all.sort((a, b) => a - b);
    rows.push([what, all[count >> 1], memory()]);
  };
  let info;
  took('open', 1, () => (info = call('open', [name, false], bytes)));
  const met = around(info.triangles, Math.floor(info.faces / 10), 5000);
  const clicks = apart(info, met.slice(4800));
  const near = around(info.triangles, clicks[2], 40);
  const point = (face) => ({ face, barycentric: [0.25, 0.5, 0.25], pinned: false, exact: 0 });
  const edit = (what, ...args) => call(`editor.1.${what}`, args);
  call('editor.new');
  clicks.forEach((face) => edit('addPoint', point(face)));
  edit('closeCurve');
  const smooth = (hand) => call('smooth', [edit('drawing'), hand]);
  const move = (k) => edit('movePoint', 0, 2, point(near[k + 1]));
  took('first leg', 1, () => call('leg', [point(clicks[0]), point(clicks[1])]));
  took('first curve', 1, () => smooth('rests'));
  took('new drawing', 15, (k) => (move(k), smooth('rests')));
  took('tau', 15, (k) => (edit('setTau', 1 + k / 10), smooth('slides')));
  took('drag', 15, (k) => (move(k + 15), smooth('drags')));
  edit('setTau', 1);
  smooth('rests');
  return { rows, drawing: [...call('saveCurves', ['drawn.json']).bytes] };
}
