// Times of the engine in Chromium, and of the driver, for the same drawing, a loop of four clicks
// at about 40 edges from a place: node times.mjs MESH. Needs the environment of the tests
// (CMakeLists.txt).
import { execFileSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, extname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { endBrowser, openPage } from './page.mjs';

const path = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), 'talweg-times-'));
cpSync(process.env.TALWEG_PAGE, folder, { recursive: true });
symlinkSync(path, join(folder, `mesh${extname(path)}`));
const source = readFileSync(new URL('times_in_page.mjs', import.meta.url), 'utf8');
writeFileSync(join(folder, 'times_in_page.js'), source);

const { serve } = await import(pathToFileURL(join(process.env.TALWEG_PAGE_SOURCE, 'serve.mjs')));
const { server, url } = await serve(folder);
const page = await openPage();
await page.page.goto(url);
page.page.setDefaultTimeout(600_000);
const { rows, drawing } = await page.page.evaluate(async (name) => {
  const { times } = await import('./times_in_page.js');
  return times(name);
}, `mesh${extname(path)}`);
await page.end();
await endBrowser();
server.close();

const [drawn, report] = [join(folder, 'drawn.json'), join(folder, 'report.json')];
writeFileSync(drawn, Uint8Array.from(drawing));
execFileSync(process.env.TALWEG_DRIVER, ['--quiet', 'smooth', path, '--curve', drawn, '--repeat', '9', '--report', report]);
const { time_ms: t, faces, peak_memory_mib: peak } = JSON.parse(readFileSync(report, 'utf8'));
const curve = t.straighten + t.trace + t.relax + t.fair;
console.log(`${basename(path)}, ${faces} faces`);
for (const [what, ms, mib] of rows) console.log(`${what.padEnd(14)} ${ms.toFixed(1).padStart(8)} ms ${mib} MiB`);
console.log(`driver: load and open ${(t.load + t.open).toFixed(1)}, new drawing ${(t.solve + curve).toFixed(1)}, `
  + `tau ${curve.toFixed(1)} ms, ${peak.toFixed(0)} MiB`);
process.exit(0);
