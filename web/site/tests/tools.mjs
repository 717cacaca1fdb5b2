// What the tests of the page share: a web server for static files, a browser, and waiting.
import { createServer } from 'node:http';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { chromium } from 'playwright-core';

const KINDS = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.json': 'application/json' };

/** The folder of the built page, and the folder for screenshots. */
export const site = process.env.SITE;
export const shots = process.env.SCREENSHOTS ?? '';

/**
 * Serves the built page below the path `base`, as any web server does: for a wrong address, 404.html. WebAssembly gets
 * no content type of its own, as from an old server.
 */
export async function serve(change = (name, bytes) => bytes, base = '/') {
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname));
        const own = path.startsWith(base) ? path.slice(base.length - 1) : '/missing';
        const name = own.endsWith('/') ? `${own}index.html` : own;
        try {
            const bytes = change(name, readFileSync(join(site, name)));
            response.writeHead(200, { 'Content-Type': KINDS[extname(name)] ?? 'application/octet-stream' }).end(bytes);
        } catch {
            response.writeHead(404, { 'Content-Type': 'text/html' }).end(readFileSync(join(site, '404.html')));
        }
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    return { url: `http://127.0.0.1:${server.address().port}${base}`, close: () => server.close() };
}

/** Starts the browser, calls `use` with a function that opens the page, and closes the browser. */
export async function browse(use) {
    const browser = await chromium.launch({
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        args: ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--enable-unsafe-webgpu'],
    });
    const faults = [];
    const requests = [];
    const open = async (url, options = {}) => {
        const context = options.context ?? await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: 'en-GB', ...options });
        const page = await context.newPage();
        page.setDefaultTimeout(120_000);
        page.on('pageerror', (error) => faults.push(String(error)));
        page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
        page.on('request', (request) => requests.push(request.url()));
        await page.goto(url);
        return page;
    };
    try {
        await use({ open, faults, requests, browser });
    } finally {
        await browser.close();
    }
}

/** Fails with `text` unless `holds`. */
export function check(holds, text) {
    if (!holds) {
        throw new Error(text);
    }
}

export function equal(actual, expected, text) {
    check(Object.is(actual, expected), `${text}: ${JSON.stringify(actual)} instead of ${JSON.stringify(expected)}`);
}

export const sha256 = (bytes) => createHash('sha256').update(bytes).digest('hex');

/** Returns the digest that the page shows when the picture is finished. */
export async function digest(page, timeout = 300_000) {
    await page.waitForSelector('#digest code', { timeout, state: 'attached' });
    return page.textContent('#digest code');
}

/** Gives two texts to the page by a link, and returns the digest of their picture. */
export async function render(page, { config, scene }) {
    await page.evaluate(async (texts) => {
        const packed = await new Response(new Blob([JSON.stringify([texts.config, texts.scene])]).stream()
            .pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer();
        const binary = Array.from(new Uint8Array(packed), (byte) => String.fromCharCode(byte)).join('');
        document.getElementById('digest').replaceChildren();
        location.hash = `#1:${btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
    }, { config, scene });
    const result = await digest(page);
    return result;
}

/** Replaces the text of an editor by typing. */
export async function type(page, editor, text) {
    await page.click(`#${editor}-editor .cm-content`);
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Delete');
    await page.keyboard.insertText(text);
}

/** Chooses an example, stops its picture, and makes the next one 240 pixels wide. */
export async function chooseNarrow(page, name) {
    await digest(page);
    await page.waitForFunction(() => document.getElementById('examples').length > 1);
    await page.selectOption('#examples', name);
    await page.click('#cancel');
    await type(page, 'config', (await textOf(page, 'config')).replace(/image_width: \d+/, 'image_width: 240'));
}

/** Time after its opening in which a list of completions takes no keys, in milliseconds: `interactionDelay` of CodeMirror. */
const LIST_IS_DEAF = 75;

/** Waits until the list of completions takes keys. Earlier, Enter and the arrows would go to the text. */
export async function completionsTakeKeys(page) {
    await page.waitForFunction((delay) => {
        const list = document.querySelector('.cm-tooltip-autocomplete');
        if (!list?.querySelector('li[aria-selected]') || list.classList.contains('cm-tooltip-autocomplete-disabled')) {
            return false;
        }
        // The element appears after the list has opened, so the list has been open for longer than the element.
        list.dataset.since ??= Date.now();
        return Date.now() - Number(list.dataset.since) >= delay;
    }, LIST_IS_DEAF);
}

export const textOf = (page, editor) =>
    page.evaluate((name) => JSON.parse(localStorage.getItem('render.texts'))[name], editor);

/** Waits until the live view has shown a frame after the one with the number `after`, and returns its number. */
export async function frame(page, after = 0) {
    await page.waitForFunction((least) => Number(document.getElementById('live-canvas').dataset.frames ?? 0) > least, after);
    return page.evaluate(() => Number(document.getElementById('live-canvas').dataset.frames));
}

/** Waits until the live view has shown everything that it was told: a gesture of several events, a text, a shader. */
export const still = (page) => page.waitForFunction(() => document.getElementById('live-canvas').ariaBusy === 'false');

/** Returns the bytes of a canvas without the fourth of each pixel, and its size. */
export const pixels = (page, id) => page.evaluate((name) => {
    const canvas = document.getElementById(name);
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return { width: canvas.width, height: canvas.height, bytes: Array.from(data).filter((_, index) => index % 4 !== 3) };
}, id);

/** Returns the root of the mean squared difference of two lists of bytes. */
export function rmse(one, other) {
    equal(one.length, other.length, 'the number of bytes');
    return Math.sqrt(one.reduce((sum, byte, index) => sum + (byte - other[index]) ** 2, 0) / one.length);
}

/** Writes a picture of the page, if a folder for them is given. */
export async function shoot(page, name) {
    if (shots) {
        mkdirSync(shots, { recursive: true });
        await page.screenshot({ path: join(shots, `${name}.png`), fullPage: true });
    }
}

/** Notes the longest time in which the page does not answer, in milliseconds. */
export const watchPauses = (page) => page.evaluate(() => {
    let last = performance.now();
    window.longest = 0;
    setInterval(() => {
        window.longest = Math.max(window.longest, performance.now() - last);
        last = performance.now();
    }, 10);
});

/** Checks that no pause since {@link watchPauses} was much longer than a piece of work that the page does at once. */
export async function checkPauses(page) {
    const [longest, work] = await page.evaluate(() => {
        const { longest } = window;
        const start = performance.now();
        Array.from({ length: 200_000 }, (_, index) => (index * 7919) % 200_003).sort((one, other) => one - other);
        return [longest, performance.now() - start];
    });
    console.log(`the page did not answer for ${longest.toFixed(0)} ms; sorting 200,000 numbers takes ${work.toFixed(0)} ms`);
    check(longest < 50 * work, `the page did not answer for ${longest} ms`);
}

/** A small scene that is rendered at once. */
export const SMALL = {
    config: 'image_width: 64\nsamples_per_pixel: 4\n',
    scene: 'matte: grey .5 .5 .5\nsphere: 0 0 0 4 grey\n',
};

/** A configuration whose picture takes minutes. */
export const SLOW = 'image_width: 640\nsamples_per_pixel: 2000\nmax_depth: 50\n';
