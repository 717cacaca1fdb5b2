// Runs the tests of the page in a browser: node web/site/tests/run.mjs [--list | NAME]
//
// SITE is the folder of the built page, EXPECTED a JSON list of pictures with their digests, RENDER_LAB the program.
// CHROMIUM may name the browser, and SCREENSHOTS a folder for pictures of the page.
import { tests as compare } from './compare.mjs';
import { tests as editing } from './editing.mjs';
import { tests as exact } from './exact.mjs';
import { tests as explain } from './explain.mjs';
import { tests as hostile } from './hostile.mjs';
import { tests as keeping } from './keeping.mjs';
import { tests as live } from './live.mjs';
import { tests as looks } from './looks.mjs';
import { tests as shaders } from './shaders.mjs';
import { browse, check, serve } from './tools.mjs';
import { tests as tasks } from './tasks.mjs';
import { tests as timing } from './timing.mjs';
import { tests as view } from './view.mjs';
import { tests as walk } from './walk.mjs';

const all = { ...compare, ...editing, ...exact, ...explain, ...hostile, ...keeping, ...live, ...looks, ...shaders, ...tasks, ...timing, ...view, ...walk };
const [name] = process.argv.slice(2);
if (name === '--list') {
    console.log(Object.keys(all).join('\n'));
} else {
    const chosen = Object.entries(all).filter(([known]) => name === undefined || known === name);
    check(chosen.length > 0, `there is no test [${name}]`);
    const { url, close } = await serve();
    for (const [known, test] of chosen) {
        await browse(async ({ open, faults, requests, browser }) => {
            await test({ open, url, faults, browser });
            // No test may leave an exception behind, or have sent a request to another host.
            check(faults.length === 0, `${known}: ${faults.join('; ')}`);
            const foreign = requests.filter((request) => !/^(http:\/\/127\.0\.0\.1:|blob:|data:|file:)/.test(request));
            check(requests.length > 3 && foreign.length === 0, `${known}: requests to ${foreign}`);
        });
        console.log(`ok: ${known}`);
    }
    close();
}
