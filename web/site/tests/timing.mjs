// Measures what a new user loads, and how long they wait for the first picture.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { check, digest, equal, render, serve, shoot, site, SMALL } from './tools.mjs';

/** Largest size of the compressed files that the first picture needs, in bytes. */
const MOST_BYTES = 800_000;

/**
 * How many times as long as the computing of the first picture it may take until that picture is there. On a machine
 * without other work, FIRST_PICTURE_LIMIT is the limit in milliseconds.
 */
const [MOST_TIMES, LIMIT] = [8, Number(process.env.FIRST_PICTURE_LIMIT ?? Infinity)];

export const tests = {
    async 'the first picture comes soon'({ open, url }) {
        const start = performance.now();
        const page = await open(url);
        await page.waitForFunction(() => document.getElementById('bar').value > 0 || document.querySelector('#digest code'), null, { polling: 20 });
        const rows = performance.now() - start;
        await digest(page);
        const whole = performance.now() - start;
        const status = await page.textContent('#status');
        console.log(`first rows after ${rows.toFixed(0)} ms, the whole picture after ${whole.toFixed(0)} ms: ${status}`);
        const computed = 1000 * Number(/, ([\d.]+) s$/.exec(status)?.[1]);
        check(whole < MOST_TIMES * computed && whole < LIMIT, `${whole} ms, of which the picture takes ${computed}`);
        await shoot(page, 'start');
        const files = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
        const names = [...new Set(['index.html', ...files.map((file) => file.slice(url.length))])];
        const bytes = names.reduce((sum, name) => sum + gzipSync(readFileSync(join(site, name))).length, 0);
        console.log(`${bytes} compressed bytes in ${names.length} files`);
        check(names.length > 6 && bytes < MOST_BYTES, `${bytes} bytes: ${names}`);
    },

    async 'the folder works under any path, and a wrong address leads to the page'({ open, faults }) {
        const { url, close } = await serve(undefined, '/some/where/');
        const page = await open(url);
        const first = await digest(page);
        const small = await render(page, SMALL);
        check(small !== first, 'another picture');
        await page.click('#share');
        await page.waitForFunction(() => document.getElementById('link').value !== '');
        check((await page.inputValue('#link')).startsWith(`${url}#`), 'a link leads to the page');
        await page.click('#tab-live');
        await page.waitForFunction(() => document.getElementById('live-canvas').dataset.frames > 0);
        equal(faults.length, 0, 'the faults');
        const wrong = await open(`${url}no/such/page`);
        await wrong.waitForFunction((home) => document.querySelector('a').href === home, url);
        await wrong.click('a');
        equal(await digest(wrong), first, 'the first picture of a new user');
        close();
        // The browser itself reports the wrong address, and those that 404.html tried.
        check(faults.splice(0).every((fault) => fault.includes('404')), 'other faults');
    },
};
