// The npm package's examples in a browser: in the page itself, and in a worker.
import assert from 'node:assert/strict';
import { cpSync, renameSync } from 'node:fs';
import { join } from 'node:path';
import { built, run, withExamples } from './npm_package.mjs';
import { openPage, servePage } from './page.mjs';

/** The example of this name as the start page of a server, with the package beside it. */
async function opened(example) {
  const folder = withExamples();
  cpSync(built, join(folder, 'talweg'), { recursive: true });
  renameSync(join(folder, example), join(folder, 'index.html'));
  const { url, unplug } = await servePage(folder);
  const page = await openPage({ url, ready: '#tau:enabled' });
  return { page, unplug };
}

const told = (page) => page.page.waitForFunction(() => /^length/.test(document.getElementById('told').textContent))
  .then(() => page.text('told'));

async function length(page) { return Number(/^length ([\d.]+)/.exec(await told(page))[1]); }

/** The example's curve has the length that the driver measures; τ = 0 makes it shorter. */
async function smooths(example) {
  const { page, unplug } = await opened(example);
  const first = await length(page);
  assert.ok(first > 5.9 && first < 6.2, `${first}: a circle around the ball`);
  await page.page.$eval('#tau', (slider) => {
    slider.value = 0;
    slider.dispatchEvent(new Event('input'));
  });
  await page.page.waitForFunction((was) => !document.getElementById('told').textContent.startsWith(`length ${was}`), {},
    first.toFixed(3));
  const second = await length(page);
  assert.ok(second < first, `${second} at τ = 0, ${first} at τ = 2`);
  await unplug();
}

export const inThePage = () => smooths('main_thread.html');
export const inAWorker = () => smooths('in_worker.html');
