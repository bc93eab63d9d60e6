// The page in a headless Chromium, used by mouse, fingers and keys like a user. Tests check visible
// texts, pictures, and saved files. TALWEG_FIREFOX, the path of a Firefox, selects that browser; it
// needs a display (xvfb-run), and has no touch events.
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = process.env.TALWEG_PAGE;
const source = process.env.TALWEG_PAGE_SOURCE;
const require = createRequire(join(source, 'package.json'));
/** Milliseconds; long enough for sanitizers, parallel tests and slow machines, since only a failure
   waits for its end. */
const patience = 120_000;

export function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

const firefox = process.env.TALWEG_FIREFOX;

export function browserPath() {
  const names = ['chromium', 'chromium-browser', 'google-chrome'];
  const folders = (process.env.PATH ?? '').split(':');
  const all = [process.env.TALWEG_CHROMIUM, ...folders.flatMap((f) => names.map((name) => join(f, name)))];
  return all.find((path) => path && existsSync(path)) ?? skip('there is no chromium');
}

export function axeSource() {
  return readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
}

let launched = null;

function inChromium() {
  return {
    executablePath: browserPath(),
    args: ['--no-sandbox', '--no-proxy-server', '--use-gl=angle', '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader', '--force-color-profile=srgb', '--disable-component-update'],
  };
}

function inFirefox(downloads) {
  return {
    browser: 'firefox', executablePath: firefox, headless: false,
    extraPrefsFirefox: {
      'webgl.force-enabled': true, 'browser.download.dir': downloads, 'browser.download.folderList': 2,
      'browser.download.alwaysOpenPanel': false, 'browser.helperApps.neverAsk.saveToDisk': '*/*',
    },
  };
}

/** One browser for all tests of a file, since its start takes longest. */
async function launch() {
  if (launched) return launched;
  if (!existsSync(join(folder, 'main.js'))) skip('the page is not built (./run page)');
  if (!existsSync(join(source, 'node_modules'))) skip('there are no npm packages (./run page)');
  const { default: puppeteer } = await import(pathToFileURL(require.resolve('puppeteer-core')));
  const { serve } = await import(pathToFileURL(join(source, 'serve.mjs')));
  const { server, url } = await serve(folder);
  const downloads = mkdtempSync(join(tmpdir(), 'talweg-firefox-'));
  const browser = await puppeteer.launch({ timeout: patience, protocolTimeout: patience,
    ...(firefox ? inFirefox(downloads) : inChromium()) });
  launched = { browser, server, url, downloads };
  return launched;
}

export async function endBrowser() {
  await launched?.browser.close();
  if (launched) rmSync(launched.downloads, { recursive: true, force: true });
  launched?.server.close();
}

/** The page from its own server, which a test can stop: { url, unplug }. */
export async function servePage(from = folder) {
  const { serve } = await import(pathToFileURL(join(source, 'serve.mjs')));
  const { server, url } = await serve(from);
  return { url, unplug: () => Promise.all([new Promise((done) => server.close(done)), server.closeAllConnections()]) };
}

/**
 * Opens the page as a new visitor; `touch` simulates a phone. `context` is the browser context of
 * an open page, `url` another server's, `script` runs before the page's own.
 */
export async function openPage({ width = 900, height = 600, touch = false, dark = false, context, url, script,
                                ready = 'html[data-ready]' } = {}) {
  const launched = await launch();
  url ??= launched.url;
  const mine = context === undefined;
  context ??= await launched.browser.createBrowserContext();
  const page = await context.newPage();
  if (script) await page.evaluateOnNewDocument(script);
  page.setDefaultTimeout(patience);
  page.setDefaultNavigationTimeout(patience);
  await page.setViewport({ width, height, ...(!firefox && { hasTouch: touch, isMobile: touch }) });
  if (!firefox) await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }]);
  const opened = new Page(context, page, url, mine, ready);
  await opened.begin();
  return opened;
}

export class Page {
  requests = [];
  errors = [];
  downloads = firefox ? launched.downloads : mkdtempSync(join(tmpdir(), 'talweg-page-'));

  constructor(context, page, url, mine, ready) {
    Object.assign(this, { context, page, url, mine, ready });
  }

  async begin() {
    this.page.on('request', (request) => this.requests.push(request.url()));
    this.page.on('pageerror', (error) => this.errors.push(error.stack ?? String(error)));
    this.page.on('console', (message) => {
      if (message.type() === 'error') this.errors.push(message.text());
    });
    if (!firefox) await this.letDownload();
    await this.load();
  }

  async letDownload() {
    const client = await this.page.createCDPSession();
    await client.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: this.downloads,
      browserContextId: this.context.id });
  }

  async load() {
    await this.page.goto(this.url);
    await this.page.waitForSelector(this.ready);
  }

  async end() {
    if (this.mine) await this.context.close();
    if (!firefox) rmSync(this.downloads, { recursive: true, force: true });
  }

  /** Waits until all work has ended. */
  async rest() {
    await this.page.waitForSelector('#main[aria-busy="false"]');
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    await this.page.waitForSelector('#main[aria-busy="false"]');
  }

  /** Chooses a file in the box that a button opens. */
  async choose(act, path) {
    const [chooser] = await Promise.all([this.page.waitForFileChooser(), this.act(act)]);
    await chooser.accept([path]);
  }

  async openMesh(path) {
    await this.choose('choose-mesh', path);
    await this.page.waitForFunction(() => /Draw on it|comes twice|face/.test(document.getElementById('told').textContent));
    await this.rest();
  }

  /** Presses a button by the name of its command; a hidden or disabled button is an error. */
  async act(act) {
    const buttons = await this.page.$$(`[data-act="${act}"]`);
    for (const button of buttons) {
      if (!(await button.isVisible())) continue;
      if (await button.evaluate((b) => b.disabled)) throw new Error(`The button ${act} is off.`);
      await button.click();
      await this.rest();
      return;
    }
    throw new Error(`No button ${act} can be seen.`);
  }

  /** The middle of the view on the screen. */
  async middle() {
    const box = await (await this.page.$('#view')).boundingBox();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  async click(x, y, options) {
    await this.page.mouse.click(x, y, options);
    await this.rest();
  }

  /** Drags with a mouse button over these pixels. */
  async drag(points, { button = 'left', steps = 8 } = {}) {
    const [[x, y], ...others] = points;
    await this.page.mouse.move(x, y);
    await this.page.mouse.down({ button });
    for (const [a, b] of others) await this.page.mouse.move(a, b, { steps });
    await this.page.mouse.up({ button });
    await this.rest();
  }

  async key(...keys) {
    for (const key of keys) await this.page.keyboard.press(key === 'Space' ? ' ' : key);
    await this.rest();
  }

  text(id) {
    return this.page.$eval(`#${id}`, (element) => element.textContent.trim());
  }

  /** The texts of the list of curves, such as "Curve 1 closed, 5 points". */
  curves() {
    return this.page.$$eval('#curve-list li button', (items) => items.map((item) => item.textContent.trim()));
  }

  /** A text of the report's table for the first curve; empty if there is no such row. */
  async row(name) {
    const rows = await this.page.$$eval('#reports table:first-of-type tr',
      (all) => all.map((r) => [r.cells[0].textContent, r.cells[1].textContent]));
    return rows.find(([head]) => head === name)?.[1] ?? '';
  }

  /** A number of the report's table; for a bound the bound's number. */
  async reported(name) {
    return Number.parseFloat((await this.row(name)).replace('≥ ', ''));
  }

  /** Runs a task that saves a file, and returns its path; later files of the same name get other
     paths. */
  async saved(task) {
    await task();
    const end = Date.now() + patience;
    while (Date.now() < end) {
      const name = readdirSync(this.downloads).find((f) => !/^saved-|^\.|\.(crdownload|part)$/.test(f));
      if (name) {
        const path = join(mkdtempSync(join(this.downloads, 'saved-')), name);
        renameSync(join(this.downloads, name), path);
        return path;
      }
      await new Promise((done) => setTimeout(done, 50));
    }
    throw new Error(`No file was saved: ${await this.text('trouble-files')}`);
  }

  /** Runs a task that saves `count` files, and returns their paths in the order of their names. */
  async savedAll(count, task) {
    const paths = [await this.saved(task)];
    while (paths.length < count) paths.push(await this.saved(() => {}));
    return paths.sort((a, b) => basename(a).localeCompare(basename(b)));
  }

  /** Saves a picture in the folder TALWEG_PAGE_PICTURES. */
  async picture(name) {
    const pictures = process.env.TALWEG_PAGE_PICTURES;
    if (!pictures) return;
    mkdirSync(pictures, { recursive: true });
    await this.rest();
    await this.page.screenshot({ path: join(pictures, `${name}.png`) });
  }

  /** Errors of the page and requests to other hosts, which every test checks. */
  faults() {
    const strangers = this.requests.filter((url) => !url.startsWith(this.url) && !/^(blob|data):/.test(url));
    return [...this.errors.map((error) => `The page has an error: ${error}`),
      ...strangers.map((url) => `The page asks another host: ${url}`)];
  }
}
