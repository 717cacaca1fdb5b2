// Tests of `render-lab view` against foreign pages and links of strangers.
import { createServer } from 'node:http';
import { chmodSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import { check, digest, equal, SMALL, textOf, type } from './tools.mjs';
import { view } from './view.mjs';

/** A picture that would take longer than anyone waits. */
const HOSTILE = { config: 'image_width: 8\nsamples_per_pixel: 9000000000000000000\n', scene: SMALL.scene };

/** A camera that no configuration can have, because differences of its numbers are infinite. */
const INFINITE = { position: [1e308, 1e308, 1e308], target: [-1e308, 0, 0], north: [0, 1, 0] };

/** Returns the fragment of a link. */
function link(texts, shown = null) {
    const packed = deflateRawSync(Buffer.from(JSON.stringify({ ...texts, modules: {}, view: shown })));
    return `#2:${packed.toString('base64url')}`;
}

/** Serves one foreign page at any free port, and calls `use` with this port. */
async function foreign(html, use) {
    const server = createServer((_, response) => response.setHeader('Content-Type', 'text/html').end(html));
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    try {
        await use(server.address().port);
    } finally {
        server.closeAllConnections();
        server.close();
    }
}

export const tests = {
    'a foreign page can neither frame nor open nor ask the page of render-lab view': ({ open, browser }) =>
        view(async ({ url, origin, config, scene }) => {
            const own = await open(url);
            await digest(own);
            // The browser has the cookie and the secret. `localhost` is another site than 127.0.0.1, and another port
            // of 127.0.0.1 is another origin of the same site, to which a browser sends the cookie.
            const target = `${origin}/${link(HOSTILE, { tab: 'live-pane', camera: null, pixel: null })}`;
            // Even an address with the secret, which no foreign page knows, is not shown in a frame.
            const known = `${url}${link(HOSTILE)}`;
            const html = `foreign<iframe src="${target}"></iframe><iframe src="${known}"></iframe><script>
                const asks = ['config', 'scene', 'files'].map((path) => fetch('${origin}/view/' + path,
                    { method: 'POST', mode: 'no-cors', credentials: 'include', body: ${JSON.stringify(JSON.stringify(HOSTILE))} }));
                Promise.allSettled(asks).then(() => { document.title = 'asked'; });
                addEventListener('click', () => { open(${JSON.stringify(target)}); });
            </script>`;
            await foreign(html, async (port) => {
                for (const host of ['localhost', '127.0.0.1']) {
                    const page = await own.context().newPage();
                    await page.goto(`http://${host}:${port}/`);
                    await page.waitForFunction(() => document.title === 'asked');
                    equal(page.frames().length, 3, `${host}: the page and its frames`);
                    for (const frame of page.frames().slice(1)) {
                        await frame.waitForLoadState();
                        equal(await frame.locator('#status').count(), 0, `${host}: the parts of the page in the frame`);
                    }
                    const opening = page.context().waitForEvent('page');
                    await page.mouse.click(5, 5);
                    const opened = await opening;
                    await opened.waitForLoadState();
                    check((await opened.textContent('body')).startsWith('403 Forbidden'), `${host}: an opened page is refused`);
                    await page.close();
                    await opened.close();
                }
            });
            equal(readFileSync(config, 'utf8'), SMALL.config, 'the configuration');
            equal(readFileSync(scene, 'utf8'), SMALL.scene, 'the scene');
            const stranger = await (await browser.newContext()).newPage();
            const answer = await stranger.goto(`${origin}/`);
            equal(answer.status(), 403, 'a browser without the secret');
            await stranger.context().close();
        }),

    'the secret leaves the address, is in no link, and stays for other tabs of the browser': ({ open }) =>
        view(async ({ url, origin }) => {
            const secret = new URL(url).searchParams.get('secret');
            const page = await open(url);
            await digest(page);
            equal(page.url(), `${origin}/`, 'the address');
            await page.click('#share');
            await page.waitForFunction(() => document.getElementById('link').value !== '');
            const shared = await page.inputValue('#link');
            check(shared.startsWith(`${origin}/#2:`), shared);
            const { texts } = await page.evaluate(async (text) => {
                const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
                return { texts: await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).text() };
            }, shared.split('#2:')[1]);
            check(texts.includes('sphere') && !texts.includes(secret) && !shared.includes(secret), 'the link has no secret');
            check(await page.evaluate(() => document.cookie) === '', 'no script reads the cookie');
            const [cookie] = await page.context().cookies();
            check(cookie.sameSite === 'Strict' && cookie.httpOnly && cookie.value !== secret, JSON.stringify(cookie));
            await page.reload();
            await digest(page);
            const other = await open(`${origin}/`, { context: page.context() });
            await digest(other);
        }),

    'the program that opens the browser does not show the secret to other users': ({ open, url: plain }) => {
        const path = process.env.PATH;
        return view(async ({ folder: own }) => {
            const opener = join(own, 'xdg-open');
            writeFileSync(opener, `#!/bin/sh\necho "$1" > ${own}/argument.part && mv ${own}/argument.part ${own}/argument\n`);
            chmodSync(opener, 0o755);
            process.env.PATH = `${own}${delimiter}${path}`;
            await view(async ({ url, origin }) => {
                const read = () => { try { return readFileSync(join(own, 'argument'), 'utf8').trim(); } catch { return ''; } };
                while (!read()) {
                    await new Promise((later) => setTimeout(later, 20));
                }
                const file = read();
                check(!file.includes(new URL(url).searchParams.get('secret')), file);
                equal(statSync(file).mode & 0o777, 0o600, 'the rights of the file');
                // The file sends the browser to the page, from where it can be loaded again.
                const page = await open(plain);
                await page.goto(pathToFileURL(file).href);
                await digest(page);
                await page.reload();
                await digest(page);
                equal(page.url(), `${origin}/`, 'the address');
            }, ['--open']);
        }).finally(() => { process.env.PATH = path; });
    },

    'a link over the files changes no file, can be cancelled, and Back shows the files': ({ open }) =>
        view(async ({ url, config, scene }) => {
            const page = await open(url);
            await digest(page);
            await page.evaluate((fragment) => (location.hash = fragment), link(HOSTILE));
            await page.waitForFunction((text) => JSON.parse(localStorage.getItem('render.texts')).config === text, HOSTILE.config);
            await page.click('#cancel');
            equal(await page.textContent('#status'), 'Cancelled.', 'the status');
            await page.goBack();
            await digest(page);
            equal(await textOf(page, 'config'), SMALL.config, 'the configuration of the files');
            equal(readFileSync(config, 'utf8') + readFileSync(scene, 'utf8'), SMALL.config + SMALL.scene, 'the files');
        }),

    'a camera beyond the range of numbers in a link is a message and no exception': async ({ open, url }) => {
        for (const shown of [
            { tab: 'live-pane', camera: INFINITE, pixel: null },
            { tab: 'pixel-pane', camera: INFINITE, pixel: [1, 1] },
            { tab: '<img src=x>', camera: { ...INFINITE, north: [0, 0, 0] }, pixel: [1e300, -5.5] },
        ]) {
            const page = await open(`${url}${link(SMALL, shown)}`);
            await page.waitForSelector('#digest code', { state: 'attached' });
            const id = shown.pixel ? 'said' : 'live-status';
            await page.waitForFunction((name) => /camera/.test(document.getElementById(name).textContent), id);
            await type(page, 'config', SMALL.config);
            check(await page.isEnabled('#render'), 'the page goes on');
            await page.context().close();
        }
    },

    'a small link that expands to 256 MiB is refused': async ({ open, url }) => {
        const page = await open(url);
        await digest(page);
        const pieces = Buffer.concat([Buffer.from('{"config":"'), Buffer.alloc(1 << 28, 97), Buffer.from('","scene":""}')]);
        await page.evaluate((fragment) => (location.hash = fragment), `#2:${deflateRawSync(pieces, { level: 9 }).toString('base64url')}`);
        await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('The link could'));
    },
};
