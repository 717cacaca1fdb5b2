// Tests of the shaders: edited modules, faults at their lines, sliders and colour pickers.
import { check, equal, frame, pixels, rmse, shoot } from './tools.mjs';
import { openLive } from './live.mjs';

/** Opens the live view with the editor of a module. */
export async function openModule(open, url, name) {
    const page = await openLive(open, url);
    await page.click('#shader-part summary');
    await page.selectOption('#module', name);
    return page;
}

/** Replaces a part of the module's text, and returns the new text. */
export async function edit(page, from, to) {
    const text = await moduleText(page);
    check(text.includes(from), `the module has [${from}]`);
    await page.focus('#shader-editor .cm-content');
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(text.replace(from, to));
    return text.replace(from, to);
}

/** Returns the text of the module, of which the editor shows a part. The editor appears a moment after its part opens. */
export async function moduleText(page) {
    await page.waitForSelector('#shader-editor .cm-content');
    return page.evaluate(() => {
        const content = document.querySelector('#shader-editor .cm-content');
        return (content.cmTile ?? content.cmView).view.state.doc.toString();
    });
}

/** Waits until the view differs from `before`, and returns by how much. */
async function differs(page, before) {
    for (let tries = 0; tries < 300; tries++) {
        const now = rmse((await pixels(page, 'live-canvas')).bytes, before.bytes);
        if (now > 0) {
            return now;
        }
        await page.waitForTimeout(100);
    }
    throw new Error('the view has not changed');
}

export const tests = {
    async 'a loop that does not end is stopped with its function, and the text can be edited'({ open, url }) {
        const page = await openModule(open, url, 'background');
        const before = await pixels(page, 'live-canvas');
        const [from, to] = ['let m =', 'var n = 0u; loop { if n > 5u { n = 0u; } n++; }\n    let m ='];
        const start = performance.now();
        await edit(page, from, to);
        await page.waitForFunction(() => document.getElementById('shader-faults').textContent.includes('background_color did not end'));
        console.log(`the loop was stopped after ${((performance.now() - start) / 1000).toFixed(1)} s`);
        equal(await page.textContent('#shader-editor .cm-lintRange-error'), 'loop', 'the marked word');
        equal(rmse((await pixels(page, 'live-canvas')).bytes, before.bytes), 0, 'the last good picture');
        await shoot(page, 'shader-loop');
        // A reload meets the same text, and goes on too.
        await page.reload();
        await page.click('#tab-live');
        await page.waitForFunction(() => document.getElementById('shader-faults').textContent.includes('background_color did not end'));
        // A fault behind the loop is marked at its place, and a loop that ends is no fault.
        await edit(page, 'n++; }', 'n++; } let q = nothing;');
        await page.waitForFunction(() => document.querySelector('#shader-editor .cm-lintRange-error')?.textContent === 'nothing');
        const shown = await page.evaluate(() => Number(document.getElementById('live-canvas').dataset.frames ?? 0));
        await edit(page, 'if n > 5u { n = 0u; } n++; } let q = nothing;', 'if n > 5u { break; } n++; }');
        await frame(page, shown);
        equal(await page.textContent('#shader-faults'), '', 'no fault is left');
        // The path of a pixel meets faults of the shaders too.
        await page.click('#tab-pixel');
        await page.waitForSelector('#pixel-steps .head');
        await edit(page, 'let m =', 'let q = nothing; let m =');
        await page.waitForFunction(() => document.querySelector('#shader-editor .cm-lintRange-error')?.textContent === 'nothing');
        check((await page.textContent('#shader-faults')).includes('nothing'), 'the fault is listed');
        await edit(page, 'let q = nothing; ', '');
        await page.waitForSelector('#pixel-steps .head');
        equal(await page.textContent('#shader-faults'), '', 'no fault is left');
    },

    async 'an edited module changes the live view, and a fault keeps the last good picture'({ open, url }) {
        const page = await openModule(open, url, 'background');
        const first = await pixels(page, 'live-canvas');
        await edit(page, 'background.light * (real(1.0) - m)', 'background.dark * (real(1.0) - m)');
        check(await differs(page, first) > 1, 'the background is another');
        const second = await pixels(page, 'live-canvas');
        await edit(page, 'direction.y /', 'direktion.y /');
        await page.waitForSelector('#shader-editor .cm-lintRange-error');
        equal(await page.textContent('#shader-editor .cm-lintRange-error'), 'direktion', 'the marked word');
        equal(await page.textContent('#shader-faults button'), 'background Line 11', 'the place');
        const { y, height } = await page.locator('#shader-faults button').first().boundingBox();
        check(y > 0 && y + height <= 800, `the fault is at ${y}`);
        check((await page.textContent('#shader-faults pre')).includes('direktion'), 'the message');
        equal(rmse((await pixels(page, 'live-canvas')).bytes, second.bytes), 0, 'the last good picture');
        await shoot(page, 'shader-fault');

        await page.selectOption('#module', 'sphere');
        await page.click('#shader-faults button');
        equal(await page.inputValue('#module'), 'background', 'the button goes to the module');
        equal(await page.locator('#module option:text-is("* background")').count(), 1, 'the changed module has a star');
        await page.reload();
        await page.waitForSelector('#shader-editor .cm-content');
        check((await moduleText(page)).includes('direktion.y'), 'the broken module is kept');
        await page.click('#tab-live');
        await page.check('#live-fixed');
        await page.waitForSelector('#shader-faults pre');
        await page.click('#shader-reset');
        await frame(page);
        await page.waitForFunction(() => !document.querySelector('#shader-faults pre'));
        equal(rmse((await pixels(page, 'live-canvas')).bytes, first.bytes), 0, 'the picture of the original text');
    },

    async 'the list of faults does not cover the line of the cursor'({ open, url }) {
        const page = await openModule(open, url, 'background');
        await page.setViewportSize({ width: 1366, height: 650 });
        await page.locator('#shader-editor .cm-line', { hasText: 'let m' }).click();
        await page.keyboard.press('Home');
        await page.evaluate(() => document.querySelector('#shader-editor .cm-activeLine').scrollIntoView({ block: 'end' }));
        await page.keyboard.insertText('x');
        await page.waitForSelector('#shader-faults pre');
        const isSeen = () => page.waitForFunction(() => {
            const [line, list] = ['#shader-editor .cm-activeLine', '#shader-faults'].map((name) => document.querySelector(name).getBoundingClientRect());
            return line.top > 0 && line.bottom <= list.top;
        });
        await isSeen();
        await page.evaluate(() => document.querySelectorAll('html, section').forEach((part) => part.scrollTo(0, 0)));
        await page.click('#shader-faults button');
        await isSeen();
    },

    async 'faults of WGSL are told at their place'({ open, url }) {
        const page = await openModule(open, url, 'background');
        const name = 'fn background_color';
        for (const [line, words, text] of [
            [1, 'A module can have no directive, ', (source) => `enable f16;\n${source}`],
            [10, 'must be at least 1', (source) => source.replace(name, `@compute @workgroup_size(0) fn f() {}\n${name}`)],
            [10, 'array', (source) => source.replace(name, `var<private> f: array<f32, 2000000000>;\n${name}`)],
            [10, 'recursive depth', (source) => source.replace(name, `const f = ${'('.repeat(999)}1${')'.repeat(999)};\n${name}`)],
        ]) {
            const source = await moduleText(page);
            await edit(page, source, text(source));
            await page.waitForFunction((part) => document.getElementById('shader-faults').innerText.includes(part), words);
            equal(await page.locator('#shader-faults button').first().textContent(), `background Line ${line}`, words);
            await page.click('#shader-reset');
            await page.waitForFunction(() => !document.querySelector('#shader-faults pre'));
        }
        // A byte order mark at the start is no fault.
        const shown = await frame(page);
        const source = await moduleText(page);
        await edit(page, source, `\uFEFF${source}`);
        await frame(page, shown);
        equal(await page.textContent('#shader-faults'), '', 'the faults');
    },

    async 'a slider and a colour picker change the text and the view'({ open, url }) {
        const page = await openModule(open, url, 'background');
        const first = await pixels(page, 'live-canvas');
        const formula = 'return background.light * (real(1.0) - m) + background.dark * m;';
        await edit(page, formula, `return gain * tint * m;`);
        await page.waitForSelector('#shader-faults pre');
        await edit(page, 'fn background_color', 'override gain: f32 = 0.5; // slider 0..2 step .25\n'
            + 'const tint = vec3<real>(1.0, 0.5, 0.2); // color\nfn background_color');
        check(await differs(page, first) > 1, 'the constants count');
        equal(await page.locator('#knobs input').count(), 2, 'a slider and a picker');
        const second = await pixels(page, 'live-canvas');
        await page.focus('#knobs input[type=range]');
        await page.keyboard.press('ArrowRight');
        check(await differs(page, second) > 1, 'the slider changes the view');
        check((await moduleText(page)).includes('gain: f32 = 0.75; // slider'), 'the slider changes the text');
        const third = await pixels(page, 'live-canvas');
        await page.fill('#knobs input[type=color]', '#00ff80');
        check(await differs(page, third) > 1, 'the picker changes the view');
        check((await moduleText(page)).includes('vec3<real>(0.0, 1.0, 0.502); // color'), await moduleText(page));
        await shoot(page, 'shader-knobs');
        equal(await page.textContent('#shader-faults'), '', 'there is no fault');
    },
};
