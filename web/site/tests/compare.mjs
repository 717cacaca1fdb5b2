// Tests of the comparison with Rust and of files, of the viewer, of a pixel's path, and of probed values.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { encode } from 'fast-png';
import { check, digest, equal, frame, pixels, render, rmse, shoot, SMALL, still } from './tools.mjs';
import { openLive, SCENE } from './live.mjs';
import { edit, openModule } from './shaders.mjs';

/** Waits for the figures of a comparison, and returns the number of pixels that differ. */
export async function figures(page) {
    await page.waitForFunction(() => /RMSE/.test(document.getElementById('compare-figures').textContent));
    return Number(await page.getAttribute('#compare-figures', 'data-differing'));
}

/** Shows the comparison with Rust's f32. */
async function compareSingle(page) {
    await page.click('#tab-compare');
    await figures(page);
    await page.selectOption('#compare-with', 'f32');
    await page.waitForFunction(() => /^(\d+).*RMSE/.test(document.getElementById('compare-figures').textContent));
    return figures(page);
}

/** The planted fault: a product with 1 / a instead of a quotient, which rounds twice. */
export const FAULT = ['let near = (h - root) / a;', 'let near = (h - root) * (real(1.0) / a);'];

export const tests = {
    async 'the shaders have the bits of Rust in f32, and nearly the exact picture'({ open, url }) {
        const page = await openLive(open, url);
        await page.click('#tab-compare');
        equal(await figures(page), 0, 'the pixels that differ at first');
        await page.selectOption('#compare-with', 'f64');
        await page.waitForFunction(() => /^[1-9].*RMSE/.test(document.getElementById('compare-figures').textContent));
        const wide = await figures(page);
        const text = await page.textContent('#compare-figures');
        console.log(text);
        check(wide > 100, `${wide} pixels differ from f64 by rounding`);
        const [exact, shader] = [await pixels(page, 'compare-exact'), await pixels(page, 'compare-shader')];
        check(rmse(exact.bytes, shader.bytes) < 1, 'the pictures look alike');
        await shoot(page, 'compare');
        equal(await compareSingle(page), 0, 'the pixels that differ from the same steps in Rust');
        // So many objects are in a hierarchy, which keeps the bits.
        const balls = Array.from({ length: 99 }, (_, index) =>
            `sphere: ${(index % 11) - 5} ${0.2 * (index % 7)} ${index / 11} .3 glass`);
        await render(page, { ...SCENE, scene: `${SCENE.scene}${balls.join('\n')}\n` });
        equal(await figures(page), 0, 'the pixels that differ in a hierarchy');
        await page.click('#compare-stage');
        await page.waitForFunction(() => document.getElementById('pixel-first').textContent === 'No bit differs.');
    },

    async 'a planted fault is seen in the map, and the first difference is at its step'({ open, url }) {
        const page = await openModule(open, url, 'sphere');
        const shown = await frame(page);
        await edit(page, ...FAULT);
        await frame(page, shown);
        const differing = await compareSingle(page);
        check(differing > 0, 'the fault makes a difference');
        check((await page.textContent('#compare-figures')).includes('has no random vectors'), 'what is not compared');
        await page.selectOption('#compare-view', 'ulps');
        check(await page.isVisible('#compare-map'), 'the map is shown');
        const colors = await pixels(page, 'compare-map');
        let marked = -1;
        let count = 0;
        for (let pixel = 0; pixel < colors.bytes.length / 3; pixel++) {
            if (colors.bytes[3 * pixel] > 0) {
                count += 1;
                marked = marked < 0 ? pixel : marked;
            }
        }
        equal(count, differing, 'the pixels of the map that are not black');
        const scale = await page.innerText('#compare-scale');
        check(/^0\s+\d+ units? in the last place\s+\(logarithmic scale\)$/.test(scale), scale);
        await shoot(page, 'compare-map');

        const box = await page.locator('#compare-stage').boundingBox();
        const place = [(marked % colors.width) + 0.5, Math.floor(marked / colors.width) + 0.5];
        await page.click('#compare-stage', {
            position: { x: (place[0] / colors.width) * box.width, y: (place[1] / colors.height) * box.height } });
        await page.waitForSelector('#pixel-steps .first');
        equal(await page.inputValue('#pixel-column'), String(Math.floor(place[0])), 'the column');
        const first = await page.textContent('#pixel-first');
        check(/^First difference: step \d+, lambda\nRust  [01] [01]{8} [01]{23}\nWGSL  [01] [01]{8} [01]{23}$/.test(first), first);
        equal((await page.textContent('#pixel-steps .first td')), 'lambda', 'the marked number');
        equal(await page.locator('#pixel-plan svg').count(), 2, 'the plan from above and from the side');
        equal(await page.locator('#pixel-plan svg').first().locator('circle:not(.hit):not(.camera), polygon').count(), 4, 'the objects');
        check((await page.getAttribute('#pixel-plan polyline', 'points')).split(' ').length >= 2, 'the way of the ray');
        await shoot(page, 'pixel');
        const unfolded = page.locator('#pixel-steps [aria-expanded=true]');
        equal(await unfolded.count(), 1, 'the open steps');
        check(/^step \d+: \d+ numbers? differs?$/.test(await unfolded.textContent()), await unfolded.textContent());
        const { height } = await page.locator('#pixel-steps').boundingBox();
        check(height < 1200, `the table is ${height} pixels high`);
        await unfolded.click();
        check(!await page.isVisible('#pixel-steps .first') && await unfolded.count() === 0, 'the step is folded');
        await page.click('#shader-reset');
        await page.waitForFunction(() => document.getElementById('pixel-first').textContent === 'No bit differs.');
    },

    async 'a small picture and a typed place show the path of a pixel'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await page.click('#tab-pixel');
        await page.waitForSelector('#pixel-picture');
        equal(await page.inputValue('#pixel-column'), '240', 'the first pixel is that in the middle');
        const first = await pixels(page, 'pixel-picture');
        check(new Set(first.bytes).size > 50, 'the picture has many colours');
        const { width, height } = await page.locator('#pixel-picture').boundingBox();
        check(width < 400, 'the picture is small');
        await page.click('#pixel-picture', { position: { x: width / 4 + 0.5, y: height / 2 } });
        await page.waitForFunction(() => document.getElementById('pixel-column').value === '120');
        await page.waitForFunction(() => document.getElementById('pixel-steps').ariaBusy === 'false');
        check(rmse((await pixels(page, 'pixel-picture')).bytes, first.bytes) > 0, 'the mark has moved');
        await shoot(page, 'pixel-picture');
        await page.fill('#pixel-column', '30');
        await page.fill('#pixel-row', '20');
        await page.press('#pixel-row', 'Enter');
        await page.waitForSelector('#pixel-steps .head');
        equal(await page.textContent('#pixel-first'), 'No bit differs.', 'the two paths');
        const caption = 'from above: x to the right, z downwards; path by Rust and by WGSL';
        equal(await page.locator('#pixel-plan figcaption').first().textContent(), caption, 'what the plan shows');
        await page.fill('#pixel-row', '9999');
        await page.press('#pixel-row', 'Enter');
        await page.waitForFunction(() => /\((sphere|ground), line/.test(document.getElementById('pixel-steps').textContent));
        equal(await page.innerText('label:has(#pixel-row)'), 'Row (0 to 269)', 'the rows that there are');
        const rows = (await page.innerText('#pixel-steps')).split('\n').map((row) => row.split('\t'));
        for (const [name, words] of [['object', '0 (sphere, line 11)'], ['material', '0 (ground, line 1)'], ['front', '1 (from outside)']]) {
            equal(rows.find((row) => row[0] === name).slice(1).join(), `${words},${words}`, name);
        }
    },

    async 'a pixel that is clicked in the picture is followed and explained'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await render(page, { config: 'image_width: 960\nsamples_per_pixel: 1\n', scene: SMALL.scene });
        const choose = async (act) => {
            const told = await page.textContent('#status');
            await page.click('#tab-exact');
            await act();
            await page.waitForFunction((before) => {
                const { textContent } = document.getElementById('status');
                return textContent.startsWith('column') && textContent !== before;
            }, told);
            const place = (await page.textContent('#status')).match(/^column (\d+), row (\d+)/).slice(1).map(Number);
            // The views of the shaders are half as wide as this picture.
            for (const [tab, size] of [['pixel', 2], ['explain', 1], ['pixel', 2]]) {
                await page.click(`#tab-${tab}`);
                await page.waitForFunction(([name, ...numbers]) => numbers.every((number, index) =>
                    document.getElementById(`${name}-${['column', 'row'][index]}`).value === String(number)),
                [tab, ...place.map((number) => Math.floor(number / size))]);
            }
            return place.join(' ');
        };
        const { width, height } = await page.locator('#exact-stage').boundingBox();
        const clicked = await choose(() => page.click('#exact-stage', { position: { x: width / 4, y: height / 2 } }));
        check(/^(239|240|241) /.test(clicked), clicked);
        equal(await choose(() => page.press('#exact-stage', 'Enter')), '480 270', 'the key Enter chooses the middle');
        // A pixel that is typed stays until another one is clicked in the picture.
        await page.fill('#pixel-column', '7');
        await page.press('#pixel-column', 'Enter');
        await page.click('#tab-exact');
        await page.click('#tab-pixel');
        equal(await page.inputValue('#pixel-column'), '7', 'the typed column');
        await page.waitForFunction(() => document.getElementById('pixel-steps').ariaBusy === 'false');
        await shoot(page, 'pixel-clicked');
    },

    async 'the slider, the linear map and blinking show both pictures'({ open, url }) {
        const page = await openLive(open, url);
        await page.click('#tab-compare');
        await figures(page);
        const clip = () => page.evaluate(() => document.getElementById('compare-shader').style.clipPath);
        equal(await clip(), 'inset(0px 0px 0px 50%)', 'the shader is right of the middle');
        await page.focus('#compare-slider');
        await page.keyboard.press('End');
        equal(await clip(), 'inset(0px 0px 0px 100%)', 'the exact picture alone');
        const box = await page.locator('#compare-stage').boundingBox();
        const at = (part) => [box.x + part * box.width, box.y + 20];
        await page.mouse.move(...at(0.5));
        await page.mouse.down();
        await page.mouse.move(...at(0.25), { steps: 4 });
        await page.mouse.up();
        equal(Math.round(await page.inputValue('#compare-slider')), 25, 'a drag moves the boundary');
        check(await page.isVisible('#compare-stage'), 'and shows no other view');
        await page.mouse.wheel(0, -100);
        const part = Number(/([\d.]+)%\)/.exec(await clip())[1]);
        check(Math.abs(part - 25) < 0.5 && await page.isVisible('.zoomed'), `the wheel zooms at the pointer: ${part}`);
        const words = await page.innerText('#compare-pane .viewing');
        const [, column] = /column (\d+), row \d+: \d+ \d+ \d+ \| \d+ \d+ \d+$/.exec(words);
        check(Math.abs(column - (await pixels(page, 'compare-exact')).width / 4) < 2, words);
        await page.click('#compare-stage-fit');
        check(await page.locator('.zoomed').count() === 0, 'the whole picture is shown again');
        await page.selectOption('#compare-view', 'linear');
        const scale = await page.innerText('#compare-scale');
        check(/(e[-+]\d+|^0\s+0)\s+\(linear scale\)$/.test(scale), scale);
        await page.selectOption('#compare-view', 'both');
        await page.check('#compare-blink');
        // The exact picture is below that of the shaders, so hiding the upper one shows the lower one.
        for (const visibility of ['hidden', 'visible', 'hidden']) {
            await page.waitForFunction((state) => document.getElementById('compare-shader').style.visibility === state, visibility);
        }
        await page.uncheck('#compare-blink');
    },

    async 'two files, or one and the picture, have the verdict of render-lab compare'({ open, url, browser }) {
        const page = await open(url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
        await digest(page);
        const { width, height, bytes } = await pixels(page, 'canvas');
        const folder = mkdtempSync(join(tmpdir(), 'files-'));
        const file = (name, content) => (writeFileSync(join(folder, name), content), join(folder, name));
        const grey = Uint8Array.from(bytes, (byte, index) => (index < 3000 ? 255 - byte : byte ^ 3));
        const head = Buffer.from(`P6 # a comment\n${width} ${height}\n255\n`);
        const one = file('one.ppm', Buffer.concat([head, Buffer.from(bytes)]));
        const other = file('other.png', encode({ width, height, data: grey, channels: 3, depth: 8 }));
        const text = file('text.ppm', `P3 ${width} ${height} 255 ${Array.from(grey).join('\n')}\n`);
        const said = spawnSync(process.env.RENDER_LAB, ['compare', one, other, '--json'], { encoding: 'utf8' });
        const { rmse: root, maximum, differing, accepted } = JSON.parse(said.stdout);
        await page.tap('#tab-compare');
        const shown = async (...files) => {
            await page.evaluate(() => document.getElementById('compare-figures').replaceChildren());
            await page.setInputFiles('#files', files);
            await figures(page);
            return page.textContent('#compare-figures');
        };
        const verdict = accepted ? 'accepts' : 'does not accept';
        const expected = `The course ${verdict} this difference: RMSE ${root.toFixed(3)}`;
        for (const files of [[one, other], [one, text], [other]]) {
            const words = await shown(...files);
            check(words.startsWith(expected) && words.includes(`at most ${maximum.toFixed(3)}`), words + said.stdout);
            equal(await figures(page), differing, 'the differing pixels');
        }
        check(!accepted && differing > width, said.stdout);
        await shoot(page, 'phone-files');
        check(await page.isDisabled('#compare-ulps'), 'bytes have no units in the last place');
        check((await page.locator('.tabs').boundingBox()).y >= 0, 'the result is in sight');
        await page.tap('#compare-most-at');
        const told = await page.innerText('#compare-pane .viewing');
        const [column, row] = told.match(/column (\d+), row (\d+)/).slice(1).map(Number);
        equal(await page.textContent('#compare-most-at'), `Largest difference: column ${column}, row ${row}`, 'the place');
        const at = 3 * (row * width + column);
        const colors = [bytes, grey].map((all) => Array.from(all.slice(at, at + 3)).join(' '));
        check(told.endsWith(`: ${colors[1]} | ${colors[0]}`), `${told} instead of ${colors}`);
        check((await shown(one)).startsWith('The course accepts this difference: RMSE 0.000'), 'the picture itself');
        check(/: (\d+ \d+ \d+) \| \1$/.test(await page.innerText('#compare-pane .viewing')), 'the numbers of the picture itself');
        equal(await page.textContent('#compare-names'), 'Left: one.ppm. Right: Picture.', 'the names');
        // "Explain" tells the clicked pixel of the picture, and the bytes of the file beside it.
        await shown(other);
        await page.tap('#compare-most-at');
        const framed = await page.locator('#compare-stage .chosen').boundingBox();
        await page.mouse.move(framed.x + framed.width / 2, framed.y + framed.height / 2);
        check((await page.innerText('#compare-pane .viewing')).includes(`column ${column}, row ${row}:`), 'the frame around the pixel');
        await page.tap('#tab-explain');
        await page.waitForFunction(() => document.querySelectorAll('#explain-steps tr').length > 3);
        equal(await page.inputValue('#explain-column') + ' ' + await page.inputValue('#explain-row'), `${column} ${row}`, 'the explained pixel');
        equal(await page.textContent('#explain-said'), `Bytes ${colors[0]}, as in the picture. other.png has ${colors[1]}.`, 'both');
        await page.tap('#tab-compare');
        await shown(one);
        await page.setInputFiles('#files', [file('bad.png', 'x')]);
        const refused = (words) => page.waitForSelector(`[role=alert]:text("${words}")`);
        await refused('bad.png: this is neither');
        const color = (selector) => page.evaluate((name) => getComputedStyle(document.querySelector(name)).color, selector);
        equal(await color('#compare-fault'), 'rgb(179, 20, 28)', 'the colour of errors');
        equal(await page.textContent('#compare-names'), 'Left: one.ppm. Right: Picture.', 'the names of the comparison before');
        equal(await figures(page), 0, 'the comparison before stays');
        await shoot(page, 'phone-refused');
        await shown(other);
        equal(await page.textContent('#compare-fault'), '', 'the refusal after another comparison');
        // A file is dropped on the page, whichever view is shown.
        await page.tap('#tab-exact');
        await page.evaluate((list) => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([new Uint8Array(list)], 'one.ppm'));
            const drop = new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true });
            document.getElementById('canvas').dispatchEvent(drop);
        }, Array.from(Buffer.from('P6 1 1 255\n123')));
        await refused('one.ppm has 1 × 1 pixels, and Picture has');
        rmSync(folder, { recursive: true });
    },

    async 'a probed value is a picture, and a number for the clicked pixel'({ open, url }) {
        const page = await openModule(open, url, 'background');
        const before = await pixels(page, 'live-canvas');
        check(!await page.isVisible('#live-probe'), 'without a probe there is none to show');
        await edit(page, '    return background.light', '    probe(m);\n    return background.light');
        await page.waitForSelector('#live-probe');
        await still(page);
        equal(rmse((await pixels(page, 'live-canvas')).bytes, before.bytes), 0, 'a probe does not change the picture');
        await page.check('#live-probe');
        await page.waitForFunction(() => document.getElementById('live-status').textContent.includes('probe from'));
        const probed = await pixels(page, 'live-canvas');
        check(rmse(probed.bytes, before.bytes) > 1, 'the picture of the value');
        equal(probed.bytes[0], probed.bytes[1], 'one number is shown as grey');
        await shoot(page, 'probe');
        const box = await page.locator('#live-canvas').boundingBox();
        await page.click('#live-canvas', { position: { x: box.width / 2, y: 2 } });
        await page.waitForFunction(() => document.getElementById('pixel-probe').textContent.startsWith('probe: '));
        const [value] = (await page.textContent('#pixel-probe')).replace('probe: ', '').split(', ').map(Number);
        // The colour of this pixel is that of the background with this m, if the ray hits nothing.
        const light = await page.evaluate(() => {
            const rows = Array.from(document.querySelectorAll('#pixel-steps tr'), (row) => row.innerText.split('\t'));
            const at = (name) => Number(rows.find((row) => row[0] === name)[2]);
            const y = at('direction.y') / Math.hypot(at('direction.x'), at('direction.y'), at('direction.z'));
            return (y + 1) / 2;
        });
        check(Math.abs(value - light) < 1e-6, `${value} is (y + 1) / 2 = ${light}`);
        await edit(page, 'probe(m);', 'probe(n);');
        await page.click('#tab-live');
        await page.waitForSelector('#shader-faults pre');
        equal(await page.textContent('#shader-editor .cm-lintRange-error'), 'n', 'a fault inside of a probe is marked');
        await frame(page);
    },
};
