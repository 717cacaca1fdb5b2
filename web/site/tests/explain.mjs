// Tests of the view that explains a pixel of the exact picture.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { SCENE } from './live.mjs';
import { check, digest, equal, pixels, render, shoot, site, SMALL } from './tools.mjs';

/** Returns what the view says about its bytes, when it has a table. */
async function told(page) {
    await page.waitForFunction(() => document.querySelectorAll('#explain-steps tr').length > 8);
    return page.textContent('#explain-said');
}

/** Types a number, and waits for another table. */
async function choose(page, input, value) {
    await page.evaluate(() => document.getElementById('explain-steps').replaceChildren());
    await page.focus(`#explain-${input}`);
    await page.keyboard.press('Control+a');
    await page.keyboard.type(`${value}\n`);
    return told(page);
}

export const tests = {
    async 'explain tells the steps of each sample, and arrives at the bytes of the picture'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await render(page, SMALL);
        const { bytes } = await pixels(page, 'canvas');
        const requests = [];
        page.on('request', (request) => requests.push(request.url()));
        await page.click('#exact-stage', { position: { x: 5, y: 5 } });
        await page.click('#tab-explain');
        await told(page);
        equal(await page.inputValue('#explain-column') + await page.inputValue('#explain-row'), '00', 'the clicked pixel');
        check(requests.some((request) => request.endsWith('explain.wasm')), `its module comes when it is needed: ${requests}`);
        for (const [column, row] of [[32, 18], [0, 35], [63, 20], [30, 19]]) {
            await choose(page, 'column', column);
            const said = await choose(page, 'row', row);
            const at = 3 * (64 * row + column);
            equal(said, `Bytes ${bytes.slice(at, at + 3).join(' ')}, as in the picture.`, `${column} ${row}`);
        }
        const steps = () => page.innerText('#explain-steps');
        const first = await steps();
        check(/\noffset\s+x = -?0\.\d+, y = -?0\.\d+: numbers [\d,]+ and [\d,]+ of ray_rng_seed\nQ\s/.test(first), first);
        check(/\nsphere, line 2\s+sphere: lambda [\d.]+ is in range\n/.test(first), first);
        check(/\nmatte\s+sends a ray along \(.*\nbytes\s+\d+ \d+ \d+: truncated$/s.test(first), first);
        await shoot(page, 'explain');
        await page.click('#explain-steps a');
        equal(await page.evaluate(() => document.activeElement.closest('.editor')?.id), 'scene-editor', 'the line of the object');
        await choose(page, 'sample', 1);
        check(await steps() !== first, 'the steps of another sample');
        check(/^Sample \(0 to \d+\)$/.test(await page.textContent('#explain-sample >> xpath=../span')), 'the number of samples');
        await page.selectOption('#language', 'es');
        check((await page.textContent('#explain-said')).endsWith(', como en la imagen.'), 'the words in Spanish');
        check(/\ndesde\s.*\nesfera, línea 2\s/s.test(await steps()), await steps());
        await page.selectOption('#language', 'en');
        await page.click('#share');
        await page.waitForFunction(() => document.getElementById('link').value !== '');
        const other = await open(await page.inputValue('#link'));
        await told(other);
        equal(await other.inputValue('#explain-column') + await other.inputValue('#explain-row'), '3019', 'the pixel of a link');
    },

    async 'explain speaks Spanish, whatever a ray meets'({ open, url }) {
        const page = await open(url, { locale: 'es-ES' });
        await digest(page);
        await render(page, { ...SCENE, config: `${SCENE.config.replace('400', '2')}max_depth: 4\n` });
        await page.click('#tab-explain');
        const seen = new Set();
        for (const [column, row] of [[42, 25], [47, 23], [53, 24], [49, 29], [44, 28], [5, 5], [20, 50]]) {
            await choose(page, 'column', column);
            await choose(page, 'row', row);
            (await page.innerText('#explain-pane')).split('\n').forEach((line) => seen.add(line));
        }
        const all = [...seen].join('\n');
        const english = all.match(/\b(the|is|are|of|and|ray|from|at|to|in|with|by|its?|an|object|draws?|counts?|candidate|sphere|cylinder|colour|background)\b/g);
        equal(english?.join() ?? '', '', 'the English words');
        // The renderer's words for parts and reasons are keys of the view's words, of which each has a Spanish text.
        const source = readFileSync(join(import.meta.dirname, '../../../cli/literal/src/intersect.rs'), 'utf8');
        const parts = source.match(/PARTS: .* = \[(.*)\]/)[1].match(/[^",]+(?=")/g).filter((part) => part.trim());
        const reasons = new Set(Array.from(source.matchAll(/=> "(.+?)"/g), ([, reason]) => reason));
        equal(`${parts.length} ${reasons.size}`, '4 6', 'the parts and the reasons of the renderer');
        const script = readdirSync(site).filter((name) => /^explain-.*js$/.test(name)).map((name) => readFileSync(join(site, name), 'utf8')).join();
        const unknown = [...parts, ...reasons].filter((words) => !new RegExp(`["{,]${words}["':]`).test(script));
        equal(unknown.join(), '', 'what the view does not know');
        for (const words of ['está en el rango', 'no cuenta: es menor que 1e-3', 'no cuenta: su punto dista del centro', 'no cuenta: su punto dista a lo',
            'no cuenta: la raíz menor', 'base superior', 'lado', 'esfera', 'viene de fuera', 'viene de dentro', 'el rayo entra', 'se refracta', 'sin raíz', 'negro', 'el fondo']) {
            check(all.includes(words), `no pixel has: ${words}`);
        }
    },

    async 'explain can be cancelled, and another pixel does not wait'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await render(page, { config: 'image_width: 2000\naspect_ratio: 2000 1\nfield_of_view: .05\nsamples_per_pixel: 8000\n', scene: SMALL.scene });
        await page.click('#tab-explain');
        await told(page);
        await page.focus('#explain-column');
        await page.keyboard.press('Control+a');
        await page.keyboard.type('1999\n');
        await page.waitForSelector('#explain-cancel');
        await page.click('#explain-cancel');
        equal(await page.textContent('#explain-said'), 'Cancelled.', 'the message');
        check(!await page.isVisible('#explain-cancel'), 'nothing is left to cancel');
        await page.keyboard.press('Shift+Tab');
        const start = performance.now();
        await choose(page, 'column', 1998);
        const whole = performance.now() - start;
        await page.keyboard.press('Control+a');
        await page.keyboard.type('1997\n');
        await page.waitForSelector('#explain-cancel');
        const next = performance.now();
        await choose(page, 'column', 1);
        check(performance.now() - next < whole / 2, `${performance.now() - next} ms after ${whole} ms for a whole row`);
    },
};
