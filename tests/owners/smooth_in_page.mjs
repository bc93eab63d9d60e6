// smooth_in_page.mjs FOLDER DRAWING: the page's engine smooths the drawing on each mesh that a line of the
// standard input names ("NAME", or "NAME repair"). Prints JSON: the curves or the error, by name.
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { talwegModule } from '../hosts/browser/talweg_module.mjs';

const [, , folder, drawing] = process.argv;
const { call } = await talwegModule(process.env.TALWEG_PAGE);
const editor = call('editor.new');

/** The drawing of a file that was made for the mesh, as the page takes it. */
function smoothed(name, repair) {
  call('open', [name, repair], readFileSync(join(folder, name)));
  const curves = call('readCurves', [basename(drawing)], readFileSync(drawing));
  call('smooth', [{ ...call(`editor.${editor}.drawing`), curves }, 'rests']);
  const file = JSON.parse(Buffer.from(call('saveCurves', ['json']).bytes).toString());
  return file.curves.map(({ closed, points }) => ({ closed, points: points.map(({ xyz }) => xyz) }));
}

const answers = {};
for (const line of readFileSync(0, 'utf8').split('\n').filter(Boolean)) {
  const [name, repair] = line.split(' ');
  try {
    answers[name] = smoothed(name, repair !== undefined);
  } catch (error) {
    answers[name] = String(error.message);
  }
}
console.log(JSON.stringify(answers));
