// Tests of `render-lab view`: the page with two files, which it loads, saves and watches.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { check, digest, equal, frame, shoot, site, SMALL, still, textOf, type } from './tools.mjs';

/**
 * Starts `render-lab view` with `texts`, of which null is a file that does not exist, and calls `use` with its address and the files. `origin` is the address
 * without the secret, and `ask` requests a path with the secret.
 */
export async function view(use, options = [], texts = SMALL) {
    const folder = mkdtempSync(join(tmpdir(), 'view-'));
    const [config, scene] = ['config', 'scene'].map((name) => join(folder, `${name}.txt`));
    for (const [path, text] of [[config, texts.config], [scene, texts.scene]]) {
        text === null || writeFileSync(path, text);
    }
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

/** Waits until the editors have this text. */
const has = (page, editor, text) => page.waitForFunction(([name, wanted]) =>
    JSON.parse(localStorage.getItem('render.texts'))[name] === wanted, [editor, text]);

/** Waits until the page says that the text of an editor is saved, or not. */
const isSaved = (page, editor, isIt) => page.waitForFunction(([name, wanted]) =>
    (document.getElementById(`${name}-state`).textContent === '') === wanted, [editor, isIt]);

export const tests = {
    'a changed file is loaded and rendered, and over unsaved text it is offered': ({ open }) => view(async ({ url, scene }) => {
        const page = await open(url);
        const first = await digest(page);
        equal(await textOf(page, 'scene'), SMALL.scene, 'the scene of the file');
        await shoot(page, 'view');
        const bright = SMALL.scene.replaceAll('.5', '.9');
        writeFileSync(scene, bright);
        await page.waitForFunction((old) => (document.querySelector('#digest code')?.textContent ?? old) !== old, first);
        equal(await textOf(page, 'scene'), bright, 'the new scene');
        await type(page, 'scene', 'this is typed');
        await page.waitForSelector('#scene-faults pre');
        for (const [button, text] of [['#offer-keep', 'this is typed'], ['#offer-take', SMALL.scene]]) {
            writeFileSync(scene, button === '#offer-keep' ? 'sphere: 0\n' : SMALL.scene);
            await page.waitForSelector('#offer', { state: 'visible' });
            equal(await textOf(page, 'scene'), 'this is typed', 'the typed text stays until the user chooses');
            await shoot(page, 'view-offer');
            await page.click(button);
            await has(page, 'scene', text);
            check(!await page.isVisible('#offer'), 'the choice is made');
        }
        equal(await page.locator('#earlier option').count(), 2, 'the typed scene is among the earlier texts');
    }),

    'texts are saved into their files, with faults too, and never over a change of another program': ({ open, faults }) =>
        view(async ({ url, ask, config, scene }) => {
            const page = await open(url);
            await digest(page);
            const wrong = 'matte: grey .5 .5\n';
            await type(page, 'scene', wrong);
            await isSaved(page, 'scene', false);
            equal(readFileSync(scene, 'utf8'), SMALL.scene, 'nothing is saved without a click');
            await page.click('#scene-save');
            await isSaved(page, 'scene', true);
            equal(readFileSync(scene, 'utf8'), wrong, 'the saved scene');
            check((await page.textContent('#status')).startsWith('scene.txt is saved'), 'the message');
            await type(page, 'scene', SMALL.scene);
            await type(page, 'config', `${SMALL.config}max_depth: 7\n`);
            for (const editor of ['config', 'scene']) {
                await isSaved(page, editor, false);
            }
            await page.keyboard.press('Control+s');
            for (const editor of ['config', 'scene']) {
                await isSaved(page, editor, true);
            }
            equal(readFileSync(config, 'utf8') + readFileSync(scene, 'utf8'), `${SMALL.config}max_depth: 7\n${SMALL.scene}`,
                'both files');
            // The page knows its own changes, so it does not load the files again.
            for (let questions = 0; questions < 2; questions++) {
                await page.waitForResponse(/view\/version$/);
            }
            check(!await page.isVisible('#offer'), 'nothing is offered');

            // Another program changes the file, and the page has not seen it yet.
            await type(page, 'config', `${SMALL.config}max_depth: 8\n`);
            const { text: version } = await ask('version');
            await page.route('**/view/version', (route) => route.fulfill({ body: version }));
            writeFileSync(config, `${SMALL.config}gamma: 1\n`);
            await page.click('#config-save');
            await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('Not saved: the file has changed'));
            equal(readFileSync(config, 'utf8'), `${SMALL.config}gamma: 1\n`, 'the change of the other program');
            await page.unroute('**/view/version');
            await page.click('#offer-keep');
            await page.click('#config-save');
            await isSaved(page, 'config', true);
            equal(readFileSync(config, 'utf8'), `${SMALL.config}max_depth: 8\n`, 'the text that the user has kept');
            // The browser reports each answer with an error.
            faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes('409 (Conflict)')));
        }),

    'unsaved text is there after a reload, and a file that has changed meanwhile is offered': ({ open }) =>
        view(async ({ url, origin, scene }) => {
            const page = await open(url);
            await digest(page);
            const own = SMALL.scene.replace(' 4 ', ' 3 ');
            await type(page, 'scene', own);
            await page.reload();
            await has(page, 'scene', own);
            await isSaved(page, 'scene', false);
            check(!await page.isVisible('#offer'), 'the file is as it was');
            await page.goto('about:blank');
            writeFileSync(scene, 'sphere: 0\n');
            await page.goto(origin);
            await page.waitForSelector('#offer', { state: 'visible' });
            await has(page, 'scene', own);
            await page.click('#offer-take');
            await has(page, 'scene', 'sphere: 0\n');
            equal(await page.locator('#earlier option').count(), 2, 'the typed scene is among the earlier texts');
        }),

    'a file that does not exist is created by saving, and a faulty one is shown': ({ open }) =>
        view(async ({ url, config, scene }) => {
            const page = await open(url);
            await page.waitForSelector('#config-faults pre');
            check((await page.textContent('#scene-state')).includes('does not exist yet'), 'the page offers to create it');
            const result = await page.innerText('#result');
            equal(result.match(/There is an error in: Configuration\./g)?.length, 1, `the error is named once: ${result}`);
            check(!result.includes('earlier texts'), `there is no earlier picture: ${result}`);
            await shoot(page, 'view-missing');
            await type(page, 'scene', SMALL.scene);
            await page.click('#scene-save');
            await isSaved(page, 'scene', true);
            equal(readFileSync(scene, 'utf8'), SMALL.scene, 'the new file');
            await type(page, 'config', SMALL.config);
            await isSaved(page, 'config', false);
            await page.click('#config-save');
            await isSaved(page, 'config', true);
            equal(readFileSync(config, 'utf8'), SMALL.config, 'the corrected file');
            await page.click('#render');
            await digest(page);
        }, [], { config: 'gama: 2\n', scene: null }),

    'the camera is saved into the file on request': ({ open }) => view(async ({ url, config }) => {
        const page = await open(url);
        await digest(page);
        await page.click('#tab-live');
        await frame(page);
        await still(page);
        await page.focus('#live-canvas');
        await page.keyboard.press('ArrowRight');
        await still(page);
        equal(readFileSync(config, 'utf8'), SMALL.config, 'nothing is saved without a click');
        await page.click('#live-save');
        await said(page, 'The camera is saved');
        check(await page.isVisible('#said'), 'the message is visible beside the live view');
        const saved = readFileSync(config, 'utf8');
        const lines = /^camera_position: ([-\d.]+) 0 ([-\d.]+)\ncamera_target: 0 0 0\ncamera_north: 0 1 0\n$/;
        check(saved.startsWith(SMALL.config), saved);
        const [, x, z] = lines.exec(saved.slice(SMALL.config.length)) ?? check(false, saved);
        check(Math.abs(Math.hypot(x, z) - 10) < 1e-4 && Math.abs(x) > 0.1, `the camera has turned to ${x} 0 ${z}`);
        await shoot(page, 'view-saved');
    }),

    'a page from a plain server has no button that saves the camera': async ({ open, url }) => {
        const page = await open(url);
        await digest(page);
        await page.click('#tab-live');
        check(await page.isVisible('#live-take') && !await page.isVisible('#live-save'), 'the button is hidden');
    },

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
