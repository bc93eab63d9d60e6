// The worker of in_worker.html: the page can be used while it works. Workers have no import map; with a
// bundler it is 'talweg'.
import { openMesh } from './talweg/index.js';

let mesh, drawn;

async function answer({ open, smooth }) {
  if (open) {
    mesh = await openMesh(open.positions, open.indices);
    drawn = [{ points: [1210, 1230, 1250, 1270].map((vertex) => mesh.at(vertex)), closed: true }];
  }
  if (smooth) postMessage({ curve: mesh.smooth(drawn, smooth).curves[0] });
}

let before = Promise.resolve();  // one after the other
onmessage = ({ data }) => {
  before = before.then(() => answer(data)).catch((error) => postMessage({ error: error.message }));
};
