// Tests of `render-lab view`: the page with two files and the native renderer.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { check, digest, equal, shoot, site, SLOW, SMALL, textOf, type } from './tools.mjs';

/** Starts `render-lab view` with the small scene, and calls `use` with its address and the files. */
async function view(use) {
    const folder = mkdtempSync(join(tmpdir(), 'view-'));
    const [config, scene] = ['config', 'scene'].map((name) => join(folder, `${name}.txt`));
    writeFileSync(config, SMALL.config);
    writeFileSync(scene, SMALL.scene);
    const program = spawn(process.env.RENDER_LAB, ['view', config, scene, '--port', '0', '--site', site]);
    try {
        const url = await new Promise((ready, fail) => {
            program.stdout.once('data', (line) => ready(String(line).trim()));
            program.stderr.once('data', (line) => fail(new Error(String(line))));
        });
        await use({ url, config, scene, program });
    } finally {
        program.kill();
        rmSync(folder, { recursive: true });
    }
}

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

    'the native renderer can be cancelled and renders the next picture': ({ open }) => view(async ({ url }) => {
        const page = await open(url);
        const first = await digest(page);
        await type(page, 'config', SLOW);
        await page.click('#render');
        await page.waitForFunction(() => document.getElementById('bar').value > 0.01, null, { polling: 50 });
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
