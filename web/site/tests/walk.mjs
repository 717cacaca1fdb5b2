// The walk of docs/shader-lab.md: a colour, a formula with a slider, and a planted fault; the progress bar of
// docs/guide.md, and the charts of a report. With the variable WALK, which names the folder of the pages, it writes
// their screenshots.
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { figures, FAULT } from './compare.mjs';
import { edit } from './shaders.mjs';
import { check, chooseNarrow, equal, frame, pixels, rmse, still, textOf, type } from './tools.mjs';

/** Largest height of a picture in pixels. */
const HIGHEST = 700;

/** Writes a picture of a part of the page. */
async function picture(page, selector, name, highest = HIGHEST) {
    if (process.env.WALK) {
        const path = join(process.env.WALK, `${name}.png`);
        mkdirSync(dirname(path), { recursive: true });
        await page.evaluate((parts) => document.querySelector(parts).scrollIntoView(), selector);
        const { x, y, width, height } = await page.locator(selector).boundingBox();
        const clip = { x, y, width, height: Math.min(height, highest) };
        await page.screenshot({ path, clip });
    }
}

/** Acts, waits for the next frame, and returns by how much the live view has changed. */
async function change(page, act) {
    const [before, number] = [await pixels(page, 'live-canvas'), await frame(page)];
    await act();
    await frame(page, number);
    await still(page);
    return rmse((await pixels(page, 'live-canvas')).bytes, before.bytes);
}

export const tests = {
    async 'the walk through the page changes a colour, a formula, and finds a planted fault'({ open, url }) {
        const page = await open(url, { viewport: { width: 1000, height: 760 } });
        await chooseNarrow(page, 'materials');
        await page.click('#tab-live');
        await frame(page);
        await still(page);
        await page.waitForFunction(() => Number(document.getElementById('live-canvas').dataset.samples) >= 64);
        await picture(page, '.result', 'shader-lab/live');
        await page.check('#live-fixed');
        await still(page);

        // 1. A colour.
        const scene = await textOf(page, 'scene');
        check(scene.includes('matte: red .85 .2 .2'), 'the scene has a red material');
        const colour = await change(page, () => type(page, 'scene', scene.replace('red .85 .2 .2', 'red .2 .7 .3')));
        check(colour > 1, `another colour changes the view by ${colour}`);

        // 2. A formula, with a slider.
        await page.click('#shader-part summary');
        await page.selectOption('#module', 'background');
        await edit(page, 'background.dark * m;', 'background.dark * m * gain;');
        await page.waitForSelector('#shader-faults pre');
        equal(await page.textContent('#shader-editor .cm-lintRange-error'), 'gain', 'the unknown name is marked');
        check(await change(page, () => edit(page, 'fn background_color',
            'override gain: f32 = 0.5; // slider 0..2 step .01\nfn background_color')) > 1, 'the formula changes the view');
        await change(page, () => page.fill('#knobs input', '1.6'));
        await picture(page, 'main', 'shader-lab/formula');
        await page.click('#shader-reset');

        // 3. A planted fault.
        await page.selectOption('#module', 'sphere');
        await edit(page, ...FAULT);
        await page.waitForFunction(() => localStorage.getItem('render.modules').includes('sphere'));
        await page.click('#tab-compare');
        const differing = await figures(page);
        check(differing > 0, `${differing} pixels differ`);
        await page.selectOption('#compare-view', 'ulps');
        console.log(await page.textContent('#compare-figures'));
        await picture(page, '.result', 'shader-lab/compare');
        const map = await pixels(page, 'compare-map');
        const marked = Array.from({ length: map.width * map.height }, (_, index) => index).filter((index) => map.bytes[3 * index] > 0);
        // Most faults are at the first hit. A later one is carried on from there, or of a ray inside an object.
        for (const chosen of marked.slice(0, 20)) {
            await page.click('#tab-compare');
            const box = await page.locator('#compare-stage').boundingBox();
            await page.click('#compare-stage', { position: {
                x: (((chosen % map.width) + 0.5) / map.width) * box.width,
                y: ((Math.floor(chosen / map.width) + 0.5) / map.height) * box.height,
            } });
            const column = String(chosen % map.width);
            await page.waitForFunction((place) => document.getElementById('pixel-column').value === place, column);
            await page.waitForFunction(() => document.getElementById('pixel-steps').ariaBusy === 'false');
            if ((await page.textContent('#pixel-first')).includes('step 0')) {
                break;
            }
        }
        console.log(await page.textContent('#pixel-first'));
        check((await page.textContent('#pixel-first')).includes(', lambda'), 'the fault is in the distance of a hit');
        await picture(page, '#pixel-pane', 'shader-lab/pixel');
    },

    async 'a walk through render-lab shows a progress bar and a page of measurements with charts'({ open, url }) {
        const folder = mkdtempSync(join(tmpdir(), 'walk-'));
        const root = join(import.meta.dirname, '../../..');
        const run = (...words) => {
            const { status, stdout, stderr } = spawnSync(words[0], words.slice(1), { cwd: root, encoding: 'utf8' });
            equal(status, 0, `${words}: ${stdout}${stderr}`);
            return stdout;
        };
        const page = await open(url, { viewport: { width: 900, height: 1500 }, colorScheme: 'dark' });
        const files = 'render scenes/materials/config.txt scenes/materials/scene.txt';
        const printed = run('script', '-qec', `${process.env.RENDER_LAB} ${files} ${join(folder, 'o.png')}`, '/dev/null');
        // The bar is drawn again and again. The line nearest to the half is shown.
        const bars = Array.from(printed.matchAll(/[\u2588\u2591]+ +(\d+) % .* left/g));
        const [half] = bars.sort(([, one], [, other]) => Math.abs(one - 50) - Math.abs(other - 50))[0];
        await page.goto('about:blank');
        await page.setContent(`<body style="margin: 0"><pre style="margin: 0; padding: 1.2em; font-size: 17px; line-height: 1.5; background: #202226; color: #e8e8ea">`
            + `$ render-lab ${files} o.png\n${half}</pre>`);
        await picture(page, 'pre', 'gallery/progress');
        run(process.env.RENDER_LAB, 'report', 'docs/report/data/bench.json', '--out', folder);
        await page.emulateMedia({ colorScheme: 'light' });
        await page.goto(pathToFileURL(join(folder, 'index.html')).href);
        check(await page.locator('svg').count() > 3, 'the charts');
        rmSync(folder, { recursive: true });
    },
};
