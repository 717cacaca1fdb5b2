// Measures how long a new user waits for the first picture.
import { check, digest, shoot } from './tools.mjs';

/** Limits in milliseconds. Machines that run other work at the same time are slower than the promise of 3 seconds. */
const LIMIT = Number(process.env.FIRST_PICTURE_LIMIT ?? 30_000);

export const tests = {
    async 'the first picture comes soon'({ open, url }) {
        const start = performance.now();
        const page = await open(url);
        await page.waitForFunction(() => document.getElementById('bar').value > 0 || document.querySelector('#digest code'), null, { polling: 20 });
        const rows = performance.now() - start;
        await digest(page);
        const whole = performance.now() - start;
        console.log(`first rows after ${rows.toFixed(0)} ms, the whole picture after ${whole.toFixed(0)} ms: ${await page.textContent('#status')}`);
        check(whole < LIMIT, `${whole} ms`);
        await shoot(page, 'start');
    },
};
