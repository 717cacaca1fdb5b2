// Tests of `render-lab view`: the page with two files and the native renderer.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { check, digest, equal, frame, shoot, site, SLOW, SMALL, still, textOf, type } from './tools.mjs';

/**
 * Starts `render-lab view` with the small scene, and calls `use` with its address and the files. `origin` is the address
 * without the secret, and `ask` requests a path with the secret.
 */
export async function view(use, options = []) {
    const folder = mkdtempSync(join(tmpdir(), 'view-'));
    const [config, scene] = ['config', 'scene'].map((name) => join(folder, `${name}.txt`));
    writeFileSync(config, SMALL.config);
    writeFileSync(scene, SMALL.scene);
    const program = spawn(process.env.RENDER_LAB, ['view', config, scene, '--port', '0', '--site', site, ...options]);
    try {
        const url = await new Promise((ready, fail) => {
            program.stdout.once('data', (line) => ready(String(line).trim()));
            program.stderr.once('data', (line) => fail(new Error(String(line))));
        });
        const { origin, searchParams } = new URL(url);
        const headers = { Authorization: `Bearer ${searchParams.get('secret')}` };
        const ask = async (path, body) => {
            const response = await fetch(`${origin}/view/${path}`, { method: body === undefined ? 'GET' : 'POST', body, headers });
            return { status: response.status, text: await response.text() };
        };
        await use({ url, origin, ask, config, scene, folder, program });
    } finally {
        program.kill('SIGKILL');
        rmSync(folder, { recursive: true });
    }
}

/** Waits until the page says a text that begins with `start`. */
const said = (page, start) =>
    page.waitForFunction((words) => document.getElementById('said').innerText.startsWith(words), start);

export const tests = {
    'both engines give the same bytes of the two files': ({ open }) => view(async ({ url }) => {
        const page = await open(url);
        const native = await digest(page);
        equal(await page.inputValue('#engine'), 'native', 'the engine at the start');
        equal(await textOf(page, 'scene'), SMALL.scene, 'the scene of the file');
        await shoot(page, 'view');
        await page.selectOption('#engine', 'browser');
        await page.evaluate(() => document.getElementById('digest').replaceChildren());
        await page.click('#render');
        equal(await digest(page), native, 'the digest of WebAssembly');
    }),

    'a changed file is loaded and rendered, and typed texts are kept': ({ open }) => view(async ({ url, scene }) => {
        const page = await open(url);
        const first = await digest(page);
        await type(page, 'scene', 'this is typed');
        await page.waitForSelector('#scene-faults pre');
        writeFileSync(scene, SMALL.scene.replaceAll('.5', '.9'));
        await page.waitForFunction((old) => (document.querySelector('#digest code')?.textContent ?? old) !== old, first);
        equal(await textOf(page, 'scene'), SMALL.scene.replaceAll('.5', '.9'), 'the new scene');
        equal(await page.locator('#earlier option').count(), 2, 'the typed scene is among the earlier texts');
        writeFileSync(scene, 'sphere: 0\n');
        await page.waitForSelector('#scene-faults pre');
        check((await page.textContent('#scene-faults pre')).startsWith('Invalid sphere parameters'), 'the message');
    }),

    'the camera is saved into the file on request, and never over a change of another program': ({ open, faults }) =>
        view(async ({ url, ask, config }) => {
            const page = await open(url);
            await digest(page);
            await page.click('#tab-live');
            await frame(page);
            await still(page);
            await page.focus('#live-canvas');
            await page.keyboard.press('ArrowRight');
            await still(page);
            equal(readFileSync(config, 'utf8'), SMALL.config, 'nothing is saved without a click');
            // What is typed stays: only the camera is written into the file.
            await type(page, 'config', `${SMALL.config}max_depth: 7\n`);
            await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).config.includes('max_depth'));
            await page.click('#live-save');
            await said(page, 'The camera is saved');
            check(await page.isVisible('#said'), 'the message is visible beside the live view');
            const saved = readFileSync(config, 'utf8');
            const lines = /^camera_position: ([-\d.]+) 0 ([-\d.]+)\ncamera_target: 0 0 0\ncamera_north: 0 1 0\n$/;
            check(saved.startsWith(SMALL.config), saved);
            const [, x, z] = lines.exec(saved.slice(SMALL.config.length)) ?? check(false, saved);
            check(Math.abs(Math.hypot(x, z) - 10) < 1e-4 && Math.abs(x) > 0.1, `the camera has turned to ${x} 0 ${z}`);
            // The page knows its own change, so it does not load the file again over what is typed.
            for (let questions = 0; questions < 2; questions++) {
                await page.waitForResponse(/view\/version$/);
            }
            const kept = await page.evaluate(() => JSON.parse(localStorage.getItem('render.texts')).config);
            check(kept.includes('max_depth: 7') && kept.includes(`camera_position: ${x} 0 ${z}`), kept);
            await shoot(page, 'view-saved');

            // Another program changes the file, and the page has not seen it yet.
            const { text: version } = await ask('version');
            await page.route('**/view/version', (route) => route.fulfill({ body: version }));
            writeFileSync(config, `${SMALL.config}gamma: 1\n`);
            await page.click('#live-save');
            await said(page, 'The camera is not saved: a file has changed');
            equal(readFileSync(config, 'utf8'), `${SMALL.config}gamma: 1\n`, 'the change of the other program');
            await page.unroute('**/view/version');
            await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).config.includes('gamma: 1'));
            equal(await page.locator('#earlier option').count(), 2, 'what was typed is among the earlier texts');
            // The browser reports each answer with an error.
            faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes('409 (Conflict)')));
        }),

    'a page from a plain server has no button that saves the camera': async ({ open, url }) => {
        const page = await open(url);
        await digest(page);
        await page.click('#tab-live');
        check(await page.isVisible('#live-take') && !await page.isVisible('#live-save'), 'the button is hidden');
    },

    'the native renderer can be cancelled and renders the next picture': ({ open }) => view(async ({ url }) => {
        const page = await open(url);
        const first = await digest(page);
        await type(page, 'config', SLOW);
        await page.click('#render');
        await page.waitForFunction(() => {
            const bar = document.getElementById('bar');
            return !bar.hidden && bar.value > 0.01;
        }, null, { polling: 50 });
        check((await page.textContent('#status')).startsWith('Rendering'), 'the status while the bar moves');
        await page.click('#cancel');
        equal(await page.textContent('#status'), 'Cancelled.', 'the status');
        await type(page, 'config', SMALL.config);
        await page.click('#render');
        equal(await digest(page), first, 'the digest');
    }),

    'the texts stay when the program has ended': ({ open, faults }) => view(async ({ url, program }) => {
        const page = await open(url);
        await digest(page);
        program.kill();
        await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('render-lab view does not'));
        await type(page, 'scene', 'still here');
        await page.waitForSelector('#scene-faults pre');
        equal(await textOf(page, 'scene'), 'still here', 'the typed scene');
        // The browser reports each request that gets no answer.
        faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes('ERR_CONNECTION_REFUSED')));
    }),
};
