// The tasks of a user's first hour, at three sizes, light and dark, in both languages.
import { readFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';
import { SCENE } from './live.mjs';
import { edit } from './shaders.mjs';
import { check, digest, equal, frame, pixels, render, rmse, shoot, SMALL, still, textOf, type } from './tools.mjs';

/** Each size with both colours and both languages, and each colour with both languages. */
const RUNS = [
    [1280, 800, 'light', 'en'], [1280, 800, 'dark', 'es'], [1366, 650, 'light', 'es'],
    [1366, 650, 'dark', 'en'], [390, 844, 'light', 'en'], [390, 844, 'dark', 'es'],
];

/** Each wrong line of a first scene, and the line that its writer meant. */
const MISTAKES = [
    ['mate: grey .5 .5 .5', 'matte: grey .5 .5 .5'],
    ['metal: gold 1 .8 .3', 'metal: gold 1 .8 .3 0'],
    ['refractive: glass -1.5', 'refractive: glass 1.5'],
    ['matte: red 1,0 0 0', 'matte: red 1.0 0 0'],
    ['sphere: 0 0 0 -1 white', 'sphere: 0 0 0 1 white'],
    ['sphere: 2 0 0 1', 'sphere: 2 0 0 1 white'],
    ['sphere: 0 2 O 1 white', 'sphere: 0 2 0 1 white'],
    ['cylinder: 0 0 0 1 0 0 0 white', 'cylinder: 0 0 0 1 0 1 0 white'],
    ['sphere: 0 -2 0 1 wite', 'sphere: 0 -2 0 1 white'],
];

/** Checks that no text is cut, that nothing covers a button, and that the window is wide enough. */
async function isSound(page, name) {
    const faults = await page.evaluate(() => {
        const clips = (one) => getComputedStyle(one).overflowY !== 'visible';
        const shown = Array.from(document.querySelectorAll('button, select, input, a, summary, p, pre, label, canvas, #digest'))
            .filter((one) => one.checkVisibility() && !one.closest('.cm-editor') && !one.closest('[aria-hidden=true]') && one.offsetHeight > 0);
        return shown.flatMap((one) => {
            const box = one.getBoundingClientRect();
            const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
            let parent = one.parentElement;
            let isInSight = x > 0 && x < innerWidth && y > 0 && y < innerHeight;
            for (; parent; parent = parent.parentElement) {
                const around = parent.getBoundingClientRect();
                isInSight &&= !clips(parent) || (y > around.top && y < around.bottom);
            }
            const hit = (isInSight && document.elementFromPoint(x, y)) || one;
            const isFree = one.contains(hit) || hit?.contains(one) || (one.tagName === 'CANVAS' && one.parentElement.contains(hit));
            const isCut = one.matches('button, p, pre, label') && one.scrollWidth > one.clientWidth + 1;
            const told = one.id || one.textContent.slice(0, 40);
            return [isFree ? '' : `${told} is below ${hit?.id || hit?.className || hit?.tagName}`, isCut ? `${told} is cut` : ''];
        }).filter(Boolean);
    });
    equal(faults.join('; '), '', name);
    equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, `${name}: what is wider than the window`);
}

/** Whether an element is wholly in the window, without scrolling. */
const inSight = (page, selector) => page.evaluate((name) => {
    const box = document.querySelector(name).getBoundingClientRect();
    return box.height > 0 && box.top >= 0 && box.bottom <= innerHeight && box.left >= 0 && box.right <= innerWidth;
}, selector);

const has = (page, editor, text) => page.waitForFunction(([name, wanted]) =>
    JSON.parse(localStorage.getItem('render.texts'))[name] === wanted, [editor, text]);

const says = (page, id, words) => page.waitForFunction(([name, text]) =>
    new RegExp(text).test(document.getElementById(name).textContent), [id, words.source]);

/** Clicks a button that saves a file, and returns the file. */
async function download(page, button) {
    const [file] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
    return { name: file.suggestedFilename(), path: await file.path() };
}

/** Opens the live view. */
async function visitLive(visit) {
    const page = await visit({ ...SCENE, config: SCENE.config.replace('400', '1') });
    await page.click('#tab-live');
    await page.check('#live-fixed');
    await frame(page);
    await still(page);
    return page;
}

/** The tasks. Each gets a function that opens the page at the size of a run, and its width. */
const TASKS = {
    async 'a first scene with nine mistakes is mended and saved'(visit, { width }) {
        const page = await visit();
        const start = 'matte: white .9 .9 .9\n';
        await type(page, 'scene', start + MISTAKES.map(([wrong]) => wrong).join('\n'));
        await page.waitForFunction(() => document.querySelectorAll('#scene-faults button').length === 9);
        const told = await page.locator('#scene-faults pre').allTextContents();
        equal(new Set(told).size, 9, 'each mistake is told once');
        const { height } = await page.locator('#scene-editor').boundingBox();
        check(height > (width > 390 ? 6 : 10) * 21, `the editor is ${height} pixels high`);
        await isSound(page, 'nine mistakes');
        await shoot(page, `task-mistakes-${width}`);
        for (let left = 9; left > 0; left--) {
            const first = page.locator('#scene-faults button').first();
            const number = Number((await first.textContent()).match(/\d+/)[0]);
            await first.click();
            await page.keyboard.press('Home');
            await page.keyboard.press('Shift+End');
            await page.keyboard.insertText(MISTAKES[number - 2][1]);
            await page.waitForFunction((count) => document.querySelectorAll('#scene-faults button').length < count, left);
        }
        const scene = start + MISTAKES.map(([, right]) => right).join('\n');
        await has(page, 'scene', scene);
        await page.keyboard.press('Control+Enter');
        await says(page, 'status', /^64 × 36/);
        check(await inSight(page, '#canvas'), 'the picture comes into sight');
        const file = await download(page, '#scene-save');
        equal(`${file.name} ${readFileSync(file.path, 'utf8')}`, `scene.txt ${scene}`, 'the saved scene');
        return page;
    },

    async 'a reload, Back and undoing lose nothing'(visit) {
        const page = await visit();
        const own = `${SMALL.scene}sphere: 9 0 0 1 grey\n`;
        await type(page, 'scene', own);
        await page.reload();
        await digest(page);
        await has(page, 'scene', own);
        await page.waitForFunction(() => document.getElementById('examples').length > 1);
        const config = await textOf(page, 'config');
        await page.selectOption('#examples', 'listings');
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).scene.startsWith('matte: mat1'));
        await page.click('#cancel');
        const example = await textOf(page, 'config');
        await page.click('#scene-editor .cm-content');
        await page.keyboard.press('Control+z');
        await has(page, 'scene', own);
        await has(page, 'config', config);
        await page.keyboard.press('Control+y');
        await has(page, 'config', example);
        await page.click('#tab-explain');
        await page.goBack();
        await page.waitForSelector('#tab-exact[aria-selected=true]');
        await page.goBack();
        await has(page, 'scene', own);
        await digest(page);
        await page.goBack().catch(() => null);
        await says(page, 'status', /^(Your text is not saved|Su texto no está guardado)/);
        check(await inSight(page, '#status'), 'the reason is in sight');
        return page;
    },

    async "yesterday's picture is compared"(visit, { width }) {
        const page = await visit();
        const { name, path } = await download(page, '#save-png');
        for (const [size, verdict] of [[4, /^(The course accepts|El curso acepta) .*RMSE 0\b/], [3, /^(The course|El curso) .*RMSE [1-9]/]]) {
            await render(page, { ...SMALL, scene: SMALL.scene.replace(' 4 ', ` ${size} `) });
            await page.click('#tab-compare');
            await page.setInputFiles('#files', { name, mimeType: 'image/png', buffer: readFileSync(path) });
            await says(page, 'compare-figures', verdict);
            check(await inSight(page, '#compare-figures'), 'the verdict is in sight');
            await isSound(page, 'the comparison');
        }
        await page.click('#compare-most-at');
        check(/: \d+ \d+ \d+ \| \d+ \d+ \d+$/.test(await page.innerText('#compare-pane .viewing')), 'the numbers of both pictures');
        await shoot(page, `task-compare-${width}`);
        return page;
    },

    async 'the camera is moved by mouse, trackpad and keys, and taken over'(visit, { width }) {
        const page = await visitLive(visit);
        await page.locator('#live-canvas').scrollIntoViewIfNeeded();
        const box = await page.locator('#live-canvas').boundingBox();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        await page.mouse.move(x, y);
        const moves = {
            mouse: async () => {
                await page.mouse.down();
                await page.mouse.move(x + 60, y + 10, { steps: 3 });
                await page.mouse.up();
            },
            trackpad: async () => {
                for (let event = 0; event < 20; event++) {
                    await page.mouse.wheel(0, -2);
                }
            },
            keys: () => page.keyboard.press('ArrowLeft'),
        };
        for (const [name, act] of Object.entries(moves)) {
            const [before, number] = [await pixels(page, 'live-canvas'), await frame(page)];
            await act();
            await frame(page, number);
            await still(page);
            const changed = rmse((await pixels(page, 'live-canvas')).bytes, before.bytes);
            check(changed > 0.5, `${name} changes the view by ${changed}`);
        }
        await isSound(page, 'the live view');
        await page.click('#live-take');
        await says(page, 'said', /./);
        check(await inSight(page, '#said'), 'the confirmation is in sight');
        await shoot(page, `task-camera-${width}`);
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).config.includes('camera_north'));
        const [, ...place] = (await textOf(page, 'config')).match(/camera_position: (\S+) (\S+) (\S+)/).map(Number);
        // Twenty events of distance 2 are four tenths of a step of a mouse wheel, of which each leaves nine tenths.
        const far = Math.hypot(place[0], place[1] - 0.5, place[2]);
        check(Math.abs(far - Math.hypot(1, 7) * 0.9 ** 0.4) < 1e-3, `the camera is ${far} away`);
        await page.keyboard.press('Control+Enter');
        await digest(page);
        equal(await page.textContent('#said'), '', 'the message that "Render" has obeyed');
        return page;
    },

    async 'the depth of a pixel is read, and a click goes to the line'(visit, { width }) {
        const page = await visit();
        await page.selectOption('#exact-view', 'depth');
        await page.waitForFunction(() => !document.getElementById('exact-scale').hidden);
        await page.hover('#exact-stage');
        await page.waitForFunction(() => / 6\.0\d+$/.test(document.querySelector('#exact .viewing').innerText));
        await shoot(page, `task-depth-${width}`);
        check(await inSight(page, '#exact-scale') && await inSight(page, '#canvas'), 'the picture and its scale are in sight');
        await isSound(page, 'the depth');
        await page.click('#exact-stage');
        await page.waitForFunction(() => document.activeElement.closest('#scene-editor'));
        equal(await page.textContent('#scene-editor .cm-activeLine'), 'sphere: 0 0 0 4 grey', 'the line of the object');
        return page;
    },

    async 'an endless loop is stopped, and there is a way out'(visit, { width }) {
        const page = await visitLive(visit);
        await page.click('#shader-part summary');
        await page.selectOption('#module', 'background');
        await edit(page, 'let m =', 'var n = 0u; loop { if n > 5u { n = 0u; } n++; }\n    let m =');
        await says(page, 'shader-faults', /background_color (did not end|no terminó)/);
        check(await inSight(page, '#shader-faults button'), 'the message is in sight');
        await isSound(page, 'the loop');
        await shoot(page, `task-loop-${width}`);
        await page.click('#shader-faults button');
        await page.waitForFunction(() => document.activeElement.closest('#shader-editor'));
        const shown = await page.evaluate(() => Number(document.getElementById('live-canvas').dataset.frames ?? 0));
        await page.click('#shader-reset');
        await frame(page, shown);
        equal(await page.textContent('#shader-faults'), '', 'no fault is left');
        return page;
    },

    async 'a pixel is explained'(visit, { width }) {
        const page = await visit();
        await page.click('#exact-stage');
        await page.click('#tab-explain');
        await says(page, 'explain-said', /^Bytes \d+ \d+ \d+, (as in the picture|como en la imagen)\.$/);
        check(await inSight(page, '#explain-said'), 'the bytes are in sight');
        await isSound(page, 'the explanation');
        await shoot(page, `task-explain-${width}`);
        await page.click('#explain-steps a');
        equal(await page.textContent('#scene-editor .cm-activeLine'), 'sphere: 0 0 0 4 grey', 'the line of the object');
        return page;
    },
};

export const tests = Object.fromEntries(Object.entries(TASKS).map(([name, act]) => [`first hour: ${name}`, async ({ open, url }) => {
    for (const [width, height, colorScheme, language] of RUNS) {
        const run = `${width} ${colorScheme} ${language}`;
        const options = { viewport: { width, height }, colorScheme, locale: language === 'es' ? 'es-ES' : 'en-GB' };
        const visit = async (texts = SMALL) => {
            const link = `#1:${deflateRawSync(JSON.stringify([texts.config, texts.scene])).toString('base64url')}`;
            const page = await open(url + link, options);
            await digest(page);
            return page;
        };
        try {
            const page = await act(visit, { width });
            await isSound(page, 'the end');
            await page.context().close();
        } catch (error) {
            throw new Error(`${run}: ${error.message}`, { cause: error });
        }
    }
}]));
