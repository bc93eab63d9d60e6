// Runs the tests of one file: run.mjs NAME [TEST]. A test is an exported function without arguments
// that throws on failure.
import { endBrowser, Page } from './page.mjs';

const [, , name, only] = process.argv;
const all = Object.entries(await import(`./test_${name}.mjs`));
const tests = all.filter(([test]) => !only || test === only);
const opened = [];
const begin = Page.prototype.begin;
Page.prototype.begin = function remembered() {
  opened.push(this);
  return begin.call(this);
};

let failed = 0;
for (const [test, run] of tests) {
  let fault = null;
  try {
    await run();
  } catch (error) {
    fault = error.stack ?? String(error);
  }
  for (const page of opened.splice(0)) {
    const faults = page.faults();
    if (faults.length > 0) fault = [fault, ...faults].filter(Boolean).join('\n');
    if (fault) await page.picture(`failed-${name}-${test}`).catch(() => {});
    await page.end();
  }
  if (fault) ++failed;
  console.log(fault ? `FAILED ${test}\n${fault}` : `passed ${test}`);
}
await endBrowser();
console.log(`${tests.length - failed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
