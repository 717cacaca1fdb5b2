// Tests of the live view: WebGPU frames, the camera's gestures, samples over frames, and a browser without WebGPU.
import { check, checkPauses, chooseNarrow, digest, equal, frame, pixels, render, rmse, shoot, still, textOf, type, watchPauses } from './tools.mjs';

/** A small scene with every material, and a camera that sees all of it. */
export const SCENE = {
    config: 'image_width: 96\nsamples_per_pixel: 400\ncamera_position: 0 1.5 -7\ncamera_target: 0 0.5 0\n',
    scene: 'matte: ground .5 .5 .5\nmatte: red .8 .2 .2\nmetal: mirror .9 .9 .9 0\nrefractive: glass 1.5\n'
        + 'sphere: 0 -100 0 100 ground\nsphere: -1.5 1 0 1 glass\nsphere: 1.5 1 0 1 mirror\n'
        + 'cylinder: 0 .6 -1 .4 0 1.2 0 red\n',
};

/** Opens the page with the scene, and shows the live view. */
export async function openLive(open, url, scene = SCENE, options = {}) {
    const page = await open(url, options);
    await digest(page);
    await render(page, scene);
    await page.click('#tab-live');
    await page.check('#live-fixed');
    await frame(page);
    await still(page);
    return page;
}

/** Acts, and returns how much the view has changed. */
async function change(page, act) {
    const before = await pixels(page, 'live-canvas');
    const number = await frame(page);
    await act();
    await frame(page, number);
    await still(page);
    return rmse((await pixels(page, 'live-canvas')).bytes, before.bytes);
}

/** Ways in which WebGPU fails until `window.works` is true, each with the words of the page. */
const FAILURES = {
    'is missing': ['This browser has no WebGPU.', () => {
        const { get } = Object.getOwnPropertyDescriptor(Navigator.prototype, 'gpu');
        const found = { get() { return window.works ? get.call(this) : undefined; } };
        Object.defineProperty(Navigator.prototype, 'gpu', found);
    }],
    'has no adapter': ['This browser has WebGPU, but no graphics device for it.', () => {
        const { requestAdapter } = GPU.prototype;
        GPU.prototype.requestAdapter = function() {
            return window.works ? requestAdapter.call(this) : Promise.resolve(null);
        };
    }],
    'throws': ['WebGPU failed: it is not enabled', () => {
        const { requestAdapter } = GPU.prototype;
        GPU.prototype.requestAdapter = function() {
            if (!window.works) { throw new DOMException('it is not enabled', 'InvalidStateError'); }
            return requestAdapter.call(this);
        };
    }],
    'gives no device': ['WebGPU failed: no device', () => {
        const { requestDevice } = GPUAdapter.prototype;
        GPUAdapter.prototype.requestDevice = function(wanted) {
            const failure = new DOMException('no device', 'OperationError');
            return window.works ? requestDevice.call(this, wanted) : Promise.reject(failure);
        };
    }],
    'gives null for a device': ['This browser has WebGPU, but no graphics device for it.', () => {
        const { requestDevice } = GPUAdapter.prototype;
        GPUAdapter.prototype.requestDevice = function(wanted) {
            return window.works ? requestDevice.call(this, wanted) : Promise.resolve(null);
        };
    }],
    'never answers': ['WebGPU has not answered within 15 s.', () => {
        const { requestDevice } = GPUAdapter.prototype;
        GPUAdapter.prototype.requestDevice = function(wanted) {
            return window.works ? requestDevice.call(this, wanted) : new Promise(() => null);
        };
    }],
    'is lost while it compiles': ['The graphics device was lost: ', () => {
        const { createComputePipelineAsync } = GPUDevice.prototype;
        GPUDevice.prototype.createComputePipelineAsync = function(wanted) {
            if (window.works) { return createComputePipelineAsync.call(this, wanted); }
            this.destroy();
            return new Promise(() => null);
        };
    }],
    'has too little memory': ['WebGPU failed: ', () => {
        const { createComputePipelineAsync } = GPUDevice.prototype;
        GPUDevice.prototype.createComputePipelineAsync = async function(wanted) {
            const made = await createComputePipelineAsync.call(this, wanted);
            const huge = { size: 2 ** 50, usage: GPUBufferUsage.STORAGE };
            if (!window.works) { setTimeout(() => this.createBuffer(huge)); }
            return made;
        };
    }],
};

export const tests = {
    async 'the live view is turned by mouse and keyboard, and its camera is taken over'({ open, url }) {
        const page = await openLive(open, url);
        const first = await pixels(page, 'live-canvas');
        equal(`${first.width} ${first.height}`, '96 54', 'the size');
        const box = await page.locator('#live-canvas').boundingBox();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        const drag = async (button, shift) => {
            await page.mouse.move(x, y);
            await page.mouse.down({ button });
            await page.mouse.move(x + 100, y + shift, { steps: 3 });
            await page.mouse.up({ button });
        };
        const acts = {
            'a drag': () => drag('left', 20),
            'a drag with the right button': () => drag('right', 20),
            'the wheel': () => page.mouse.wheel(0, -300),
            'an arrow key': () => page.keyboard.press('ArrowRight'),
            'an arrow key with Shift': () => page.keyboard.press('Shift+ArrowUp'),
            'the key +': () => page.keyboard.press('+'),
        };
        for (const [name, act] of Object.entries(acts)) {
            const changed = await change(page, act);
            check(changed > 1, `${name} changes the view by ${changed}`);
        }
        await shoot(page, 'live');
        const moved = await pixels(page, 'live-canvas');
        const number = await frame(page);
        await page.click('#live-take');
        await page.waitForFunction(() => !JSON.parse(localStorage.getItem('render.texts')).config.includes('0 1.5 -7'));
        const config = await textOf(page, 'config');
        equal(config.match(/camera_position:/g).length, 1, 'the number of lines with the position');
        check(/camera_north: 0 1 0\n$/.test(config), config);
        await frame(page, number);
        await still(page);
        // The lines have six digits, so edges move by a pixel at most.
        const again = rmse((await pixels(page, 'live-canvas')).bytes, moved.bytes);
        check(again < 8, `the view of the lines differs by ${again}`);
        await page.click('#tab-exact');
        await page.click('#render');
        await page.waitForFunction(() => document.querySelector('#digest code'));
        await page.keyboard.press('Control+z');
    },

    async 'after an error all views show the earlier texts and say so'({ open, url }) {
        const page = await openLive(open, url);
        await page.click('#live-take');
        await page.waitForFunction(() => document.getElementById('said').innerText.endsWith('"Render" makes its exact picture.'));
        await type(page, 'config', `${SCENE.config}camera_position: 1 -4 0\n`);
        await page.waitForFunction(() => /^The camera is inside an object \(sphere, line \d+\)\. \d/
            .test(document.getElementById('live-status').textContent));
        equal(await page.textContent('#said'), '', 'the message about the earlier camera');
        await type(page, 'config', 'gamma: -1\n');
        for (const [tab, part] of [['live', '#live-canvas'], ['compare', '#compare-stage'], ['pixel', '#pixel-plan svg'], ['exact', '#canvas']]) {
            await page.click(`#tab-${tab}`);
            await page.waitForSelector(part);
            await page.waitForFunction(() => document.getElementById('old').innerText.startsWith('There is an error in: Configuration. What'));
            if (tab === 'compare') {
                await page.waitForFunction(() => /RMSE/.test(document.getElementById('compare-figures').textContent));
                await page.click('#compare-stage');
            }
        }
    },

    async 'the wheel follows its distance: a trackpad and a mouse come as near'({ open, url }) {
        const page = await openLive(open, url);
        const box = await page.locator('#live-canvas').boundingBox();
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
        const distance = async (events, delta) => {
            await page.evaluate(([count, deltaY]) => {
                const canvas = document.getElementById('live-canvas');
                for (let event = 0; event < count; event++) {
                    canvas.dispatchEvent(new WheelEvent('wheel', { deltaY, cancelable: true }));
                }
            }, [events, delta]);
            await page.click('#live-take');
            await page.waitForFunction(() => document.getElementById('said').innerText.endsWith('makes its exact picture.'));
            const text = await page.locator('#config-editor .cm-line').allTextContents();
            const [, x, y, z] = text.join('\n').match(/camera_position: (\S+) (\S+) (\S+)/).map(Number);
            // The views take the new camera after a pause.
            await page.waitForFunction((position) => JSON.parse(localStorage.getItem('render.texts')).config.includes(position), `${x} ${y} ${z}`);
            await page.waitForTimeout(500);
            await still(page);
            return Math.hypot(x, y - 0.5, z);
        };
        await page.focus('#live-canvas');
        const start = Math.hypot(1, 7);
        const [one, fifty, few] = [await distance(1, -100), await distance(50, -2), await distance(20, 2)];
        check(Math.abs(one / start - 0.9) < 1e-4 && Math.abs(fifty / one - 0.9) < 1e-4, `${start}, ${one}, ${fifty}`);
        check(few > fifty && few < 1.1 * fifty, `20 events of distance 2 lead from ${fifty} to ${few}`);
    },

    async 'the key Home goes back to the camera of the text'({ open, url }) {
        const page = await openLive(open, url);
        const first = await pixels(page, 'live-canvas');
        await page.focus('#live-canvas');
        check(await change(page, () => page.keyboard.press('ArrowLeft')) > 1, 'the view turns');
        await change(page, () => page.keyboard.press('Home'));
        equal(rmse((await pixels(page, 'live-canvas')).bytes, first.bytes), 0, 'the difference from the first view');
    },

    async 'the time of a frame is shown if it takes longer than a second'({ open, url }) {
        const page = await openLive(open, url);
        await page.focus('#live-canvas');
        // The clock of the page goes on by 1.5 seconds between two looks at it.
        await page.evaluate(() => {
            const now = performance.now.bind(performance);
            let later = 0;
            performance.now = () => now() + (later += 1500);
        });
        await change(page, () => page.keyboard.press('ArrowLeft'));
        const status = await page.textContent('#live-status');
        const seconds = Number(status.match(/, the last frame took (\d+\.\d) s, /)?.[1]);
        check(seconds >= 1.5, `the time in: ${status}`);
    },

    async 'two fingers come closer on a touch screen'({ open, url }) {
        const page = await openLive(open, url, SCENE, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
        await page.locator('#live-canvas').scrollIntoViewIfNeeded();
        const box = await page.locator('#live-canvas').boundingBox();
        const session = await page.context().newCDPSession(page);
        const touch = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
        const at = (distance) => [-1, 1].map((side, id) => (
            { x: box.x + box.width / 2 + side * distance, y: box.y + box.height / 2, id }));
        const changed = await change(page, async () => {
            await touch('touchStart', at(30));
            for (const distance of [45, 60, 75]) {
                await touch('touchMove', at(distance));
            }
            await touch('touchEnd', []);
        });
        check(changed > 1, `two fingers change the view by ${changed}`);
        equal(await page.evaluate(() => document.documentElement.scrollWidth), 390, 'the width that the page needs');
        await shoot(page, 'live-phone');
    },

    async 'a tap follows the pixel below the finger'({ open, url }) {
        const page = await openLive(open, url, SCENE, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
        for (const [right, down] of [[0.3, 0.2], [0.8, 0.4], [0.5, 0.1]]) {
            await page.tap('#tab-live');
            const { x, y, width, height } = await page.locator('#live-canvas').boundingBox();
            await page.touchscreen.tap(x + right * width, y + down * height);
            await page.waitForSelector('#pixel-pane', { state: 'visible' });
            await page.waitForTimeout(500);
            const size = await page.evaluate(() => ['width', 'height'].map((name) => document.getElementById('pixel-picture')[name]));
            const place = await Promise.all(['column', 'row'].map((name) => page.inputValue(`#pixel-${name}`)));
            const far = [right, down].map((part, axis) => Math.abs(Number(place[axis]) + 0.5 - part * size[axis]));
            check(Math.max(...far) <= 1.5, `${place} of ${size} instead of ${[right, down]}`);
        }
    },

    async 'samples over frames come near to the exact picture'({ open, url }) {
        const page = await openLive(open, url);
        const exact = await pixels(page, 'canvas');
        const first = rmse((await pixels(page, 'live-canvas')).bytes, exact.bytes);
        check((await page.textContent('#live-status')).includes('deterministic light'), 'the view says so');
        await page.uncheck('#live-fixed');
        const after = async (count) => {
            await page.waitForFunction((least) => Number(document.getElementById('live-canvas').dataset.samples) >= least, count);
            const samples = Number(await page.getAttribute('#live-canvas', 'data-samples'));
            return [samples, rmse((await pixels(page, 'live-canvas')).bytes, exact.bytes)];
        };
        const [[less, few], [more, many]] = [await after(2), await after(128)];
        console.log(`difference from the exact picture with 400 samples: deterministic ${first.toFixed(1)}, `
            + `${less} samples ${few.toFixed(1)}, ${more} samples ${many.toFixed(1)} of 255`);
        // Noise falls with the root of the samples, and rounding to bytes stays. A busy machine shows the first one late.
        const expected = Math.sqrt((1 / more + 1 / 400) / (1 / less + 1 / 400));
        check(many < 6 && many / few < 1.8 * expected, `${less}: ${few} and then ${more}: ${many}`);
        await shoot(page, 'live-samples');
    },

    async 'a browser without WebGPU shows a small picture and says so'({ open, url, browser }) {
        for (const [name, [words, fail]] of Object.entries(FAILURES)) {
            const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: 'en-GB' });
            await context.addInitScript(fail);
            const page = await open(url, { context });
            await digest(page);
            await page.click('#tab-live');
            await page.waitForSelector('#live-none');
            const width = (size) => page.waitForFunction((wanted) =>
                document.getElementById('live-canvas').width === wanted, size);
            await width(160);
            await still(page);
            const cause = await page.textContent('#gpu-cause');
            check(cause.startsWith(words), `${name}: ${cause}`);
            const shown = await pixels(page, 'live-canvas');
            check(new Set(shown.bytes).size > 50, `${name}: the picture has many colours`);
            await page.focus('#live-canvas');
            check(await change(page, () => page.keyboard.press('ArrowRight')) > 1, `${name}: the view turns`);
            await shoot(page, `live-webgpu-${name.replaceAll(' ', '-')}`);
            await page.selectOption('#language', 'es');
            const spanish = await page.textContent('#live-none');
            check(/WebGPU|dispositivo/.test(spanish) && !spanish.includes(words), `${name}: ${spanish}`);
            for (const [tab, part] of [['compare', '#compare-none'], ['pixel', '#pixel-pane']]) {
                await page.click(`#tab-${tab}`);
                check(await page.isVisible('#live-none') && await page.isVisible(part), `${name}: ${tab} says so too`);
            }
            await page.evaluate(() => (window.works = true));
            await page.click('#gpu-again');
            await page.waitForSelector('#live-none', { state: 'hidden' });
            await page.click('#tab-live');
            await width(480);
            await context.close();
        }
    },

    async 'an adapter without information has a name, and its device is used'({ open, url, browser }) {
        const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: 'en-GB' });
        await context.addInitScript(() =>
            Object.defineProperty(GPUAdapter.prototype, 'info', { get: () => undefined }));
        const page = await openLive(open, url, SCENE, { context });
        check((await page.textContent('#live-status')).endsWith(', WebGPU'), await page.textContent('#live-status'));
    },

    async 'a busy view says so, and a picture of another scene is removed'({ open, url }) {
        const page = await openLive(open, url);
        await page.uncheck('#live-fixed');
        await page.waitForFunction(() => / samples,/.test(document.getElementById('live-status').textContent));
        await page.evaluate(() => {
            const { postMessage } = Worker.prototype;
            Worker.prototype.postMessage = function(message) {
                setTimeout(() => postMessage.call(this, message), message.request?.kind === 'prepare' ? 3000 : 0);
            };
        });
        await type(page, 'config', `${SCENE.config}gamma: 1\n`);
        await page.waitForSelector('#live-pane .busy');
        check((await pixels(page, 'live-canvas')).bytes.some((byte) => byte > 0), 'the picture is pale, and stays');
        await still(page);
        await page.selectOption('#examples', 'cylinders');
        await page.waitForSelector('#live-pane .busy');
        await page.waitForFunction(() => getComputedStyle(document.querySelector('#live-pane .busy')).opacity === '1');
        const { bytes } = await pixels(page, 'live-canvas');
        check(bytes.every((byte) => byte === 0), 'the picture of the other scene is removed');
        await shoot(page, 'live-busy');
        await still(page);
        check((await pixels(page, 'live-canvas')).bytes.some((byte) => byte > 0), 'the new picture');
    },

    async 'a large scene gets its full size at rest, in parts, while the page answers'({ open, url }) {
        const page = await open(url);
        await chooseNarrow(page, 'ten-thousand');
        await page.click('#render');
        await digest(page);
        await watchPauses(page);
        await page.click('#tab-live');
        await page.check('#live-fixed');
        const width = (least, most) => page.waitForFunction(([from, to]) => {
            const { width } = document.getElementById('live-canvas');
            return from <= width && width <= to;
        }, [least, most]);
        const last = await frame(page);
        await width(16, 98);
        await page.waitForSelector('#live-pane .busy');
        await width(240, 240);
        equal(await page.getAttribute('#live-canvas', 'aria-busy'), 'true', 'the first rows are shown, and the rest is computed');
        equal(await page.evaluate(() => getComputedStyle(document.getElementById('live-canvas')).opacity), '1', 'no old picture');
        await shoot(page, 'live-rest');
        await page.focus('#live-canvas');
        await page.keyboard.press('ArrowRight');
        await width(16, 98);
        check(await frame(page, last) > last, 'a movement ends the large picture');
        await still(page);
        check(/^240 × 135, deterministic light/.test(await page.textContent('#live-status')), await page.textContent('#live-status'));
        await page.keyboard.press('Home');
        await page.uncheck('#live-fixed');
        await still(page);
        const after = async (count) => {
            await page.waitForFunction((least) => Number(document.getElementById('live-canvas').dataset.samples) >= least, count);
            return rmse((await pixels(page, 'live-canvas')).bytes, (await pixels(page, 'canvas')).bytes);
        };
        const [few, more] = [await after(1), await after(3)];
        check(more < 0.75 * few, `the difference from the exact picture is ${few} and then ${more}`);
        await checkPauses(page);
    },

    async 'frames of the live view are counted'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await page.waitForFunction(() => document.getElementById('examples').length > 1);
        const both = (name) => [true, false].map((fixed) => [name, fixed]);
        for (const [name, fixed] of ['materials', 'ten-thousand'].flatMap(both)) {
            await page.selectOption('#examples', name);
            await page.evaluate(() => document.getElementById('cancel').click());
            await page.click('#tab-live');
            await page.setChecked('#live-fixed', fixed);
            await page.waitForTimeout(500);
            const [count, rate] = await page.evaluate(async () => {
                const canvas = document.getElementById('live-canvas');
                const frames = () => Number(canvas.dataset.frames ?? 0);
                const turnUntil = async (isOver) => {
                    // A busy machine delays the keys too, so a frame takes at most as long as 200 of them.
                    for (let keys = 0; keys < 4000 && !isOver(); keys++) {
                        canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight' }));
                        await new Promise((ready) => setTimeout(ready, 15));
                    }
                };
                // The first frames share the processor with the end of the page's start.
                const warm = frames() + 10;
                await turnUntil(() => frames() >= warm);
                const [begin, start] = [performance.now(), frames()];
                await turnUntil(() => frames() >= start + 20);
                return [frames() - start, ((frames() - start) * 1000) / (performance.now() - begin)];
            });
            const status = await page.textContent('#live-status');
            console.log(`${rate.toFixed(1)} frames a second of scenes/${name}, ${status}`);
            check(count >= 20 && rate > Number(process.env.LEAST_RATE ?? 0), `${count} frames, ${rate} a second`);
        }
    },
};
