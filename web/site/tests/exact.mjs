// Tests of the exact picture: rows, bar, cancel, digest, saved files, and digests of many scenes.
import { readFileSync } from 'node:fs';
import { decode } from 'fast-png';
import { check, digest, equal, pixels, render, serve, sha256, shoot, SLOW, SMALL, type } from './tools.mjs';

const lastRow = (page) => page.evaluate(() => {
    const canvas = document.getElementById('canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let row = canvas.height;
    while (row > 0 && data[4 * canvas.width * row - 1] === 0) {
        row -= 1;
    }
    return row;
});

/** Compares the digests of all pictures in the list EXPECTED with those of the page. */
async function pictures(open, url) {
    const page = await open(url);
    await digest(page);
    const all = JSON.parse(readFileSync(process.env.EXPECTED, 'utf8'));
    check(all.length >= 22, `${all.length} pictures are too few`);
    for (const picture of all) {
        equal(await render(page, picture), picture.digest, picture.name);
    }
    console.log(`${all.length} digests are equal, with ${await page.evaluate(() => document.documentElement.dataset.instructionSet)}`);
    return page;
}

export const tests = {
    async 'rows appear as they are done, and a picture can be cancelled'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'config', SLOW);
        await page.keyboard.press('Control+Enter');
        await page.waitForFunction(() => document.getElementById('bar').value > 0.01, null, { polling: 50 });
        // Until the first row has come, the canvas has the 270 rows of the picture before.
        await page.waitForFunction(() => document.getElementById('canvas').height === 360, null, { polling: 50 });
        const rowAfter = async (row) => {
            let last = row;
            for (let tries = 0; last <= row && tries < 200; tries++) {
                await page.waitForTimeout(50);
                last = await lastRow(page);
            }
            return last;
        };
        const first = await rowAfter(0);
        const second = await rowAfter(first);
        check(first > 0 && second > first && second < 360, `${first} and then ${second} rows of 360`);
        // The time is told from the second second on.
        await page.waitForFunction(() => document.getElementById('left').textContent.includes(','), null, { polling: 50 });
        const left = await page.textContent('#left');
        check(/^\d+ %, [\d,]+ s left$/.test(left), `the share and the time left: ${left}`);
        await shoot(page, 'rows');
        await page.click('#cancel');
        equal(await page.textContent('#status'), 'Cancelled.', 'the status');
        check(!await page.isVisible('#bar') && await page.isDisabled('#save-ppm'), 'nothing can be saved');
        const rest = await lastRow(page);
        await page.waitForTimeout(1000);
        equal(await lastRow(page), rest, 'the rows a second after cancelling');
    },

    async 'numbers follow the picture, and a picture of other texts is marked'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await render(page, SMALL);
        await page.hover('#exact-stage');
        const told = () => page.innerText('#exact .viewing');
        check(/column 3[12], row 1[78]: /.test(await told()), await told());
        const opacity = (id) => page.evaluate((name) => Number(getComputedStyle(document.getElementById(name)).opacity), id);
        await type(page, 'config', 'image_width: 32\nsamples_per_pixel: 1\nfield_of_view: 150\n');
        await page.waitForFunction(() => document.getElementById('old').innerText.startsWith('The texts have changed'));
        check(await opacity('digest') < 1 && await opacity('save-png') < 1, 'the digest and the buttons are marked');
        await page.keyboard.press('Control+Enter');
        await page.waitForFunction(() => /^32 × 18, .* s$/.test(document.getElementById('status').textContent));
        const [, scale, column, row, colors] = (await told()).match(/(\d+) %\s*column (1[56]), row ([89]): (.*)$/) ?? [];
        const [width, own] = await page.evaluate(([x, y]) => [document.getElementById('exact-stage').clientWidth,
            document.getElementById('canvas').getContext('2d').getImageData(x, y, 1, 1).data.slice(0, 3).join(' ')],
        [Number(column), Number(row)]);
        equal(`${scale} % ${colors}`, `${Math.round((100 * width) / 32)} % ${own}`, 'the zoom and the numbers');
        equal(`${await opacity('digest')} ${await page.isVisible('#old')}`, '1 false', 'the mark of the new picture');
    },

    async 'other views tell the distance, the normal and the object of a pixel, and a click goes to its line'({ open, url }) {
        const page = await open(url);
        await digest(page);
        const scene = 'matte: grey .5 .5 .5\n\nsphere: 0 0 0 4 grey\ncylinder: 30 30 0 1 0 1 0 grey\n';
        const config = 'image_width: 65\naspect_ratio: 1 1\nsamples_per_pixel: 1\ncamera_position: 0 0 -10\n';
        await render(page, { config, scene });
        const picture = (await pixels(page, 'canvas')).bytes.join();
        const told = async (view) => {
            await page.selectOption('#exact-view', view);
            await page.waitForFunction((name) => document.getElementById('exact-scale').hidden === (name === 'picture'), view);
            await page.hover('#exact-stage');
            return page.innerText('#exact .viewing');
        };
        // The ray through the middle meets the sphere of radius 4 at 10 - 4 units, with its normal towards the camera.
        for (const [view, words] of [['depth', /: 6\.0000\d+$/], ['normal', /: -?0\.\d{4} -?0\.\d{4} -(1\.0000|0\.999\d)$/],
            ['object', /: sphere, line 3$/], ['cost', /: 2$/]]) {
            await page.waitForTimeout(100);
            const words2 = await told(view);
            check(words.test(words2), `${view}: ${words2}`);
            await shoot(page, `exact-${view}`);
        }
        await page.selectOption('#exact-view', 'depth');
        equal(Number(await page.inputValue('#exact-low')), 6, 'the smallest distance');
        await page.click('#exact-stage');
        await page.keyboard.type('x');
        await page.waitForFunction((text) => JSON.parse(localStorage.getItem('render.texts')).scene === text,
            scene.replace('sphere:', 'xsphere:'));
        await page.keyboard.press('Backspace');
        await page.selectOption('#exact-view', 'picture');
        await page.waitForFunction(() => document.getElementById('exact-scale').hidden);
        equal((await pixels(page, 'canvas')).bytes.join(), picture, 'the picture again');
        await page.fill('#exposure', '2');
        // The default gamma is 2.2, and two steps are a factor of four.
        const filter = await page.evaluate(() => document.getElementById('canvas').style.filter);
        equal(Number(/brightness\(([\d.]+)\)/.exec(filter)[1]).toFixed(4), (4 ** (1 / 2.2)).toFixed(4), 'the factor of the bytes');
    },

    async 'a click in a picture wider than its views finds the pixel and the object, in every view'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await render(page, { scene: 'matte: grey .5 .5 .5\n\nsphere: 0 0 0 1 grey\n',
            config: 'image_width: 1920\nsamples_per_pixel: 1\ncamera_position: 0 0 -10\ncamera_target: 0 0 0\n' });
        for (const view of ['picture', 'object']) {
            await page.selectOption('#exact-view', view);
            await page.waitForFunction((width) => document.getElementById('canvas').width === width, view === 'picture' ? 1920 : 1280);
            for (const [part, object] of [[0.5, 'sphere, line 3'], [0.1, 'background']]) {
                const { width, height } = await page.locator('#exact-stage').boundingBox();
                await page.click('#exact-stage', { position: { x: part * width, y: 0.5 * height } });
                await page.waitForFunction((name) => document.getElementById('status').textContent.endsWith(`: ${name}`), object);
                const [column, row] = (await page.textContent('#status')).match(/^column (.*), row (.*):/).slice(1).map(Number);
                check(Math.abs(column - 1920 * part) < 4 && Math.abs(row - 540) < 4, `${view}: ${column} ${row}`);
                check((await page.innerText('#exact .viewing')).includes(`column ${column}, row ${row}: `), 'both places are one');
            }
        }
    },

    async 'the saved files have the bytes of the picture'({ open, url }) {
        const page = await open(url);
        await digest(page);
        const shown = await render(page, SMALL);
        check((await page.textContent('#digest')).endsWith('the bytes of render-aos'), 'the words');
        const saved = async (button) => {
            const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
            return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
        };
        const ppm = await saved('#save-ppm');
        equal(ppm.name, 'picture.ppm', 'the name');
        equal(sha256(ppm.bytes), shown, 'the digest of the file');
        const numbers = ppm.bytes.toString().trim().split(/\s+/).slice(4).map(Number);
        const png = await saved('#save-png');
        const image = decode(png.bytes);
        equal(`${png.name} ${image.width} ${image.height} ${image.channels}`, 'picture.png 64 36 3', 'the PNG');
        equal(numbers.length, 64 * 36 * 3, 'the numbers of the PPM');
        equal(Array.from(image.data).join(), numbers.join(), 'the pixels of the PNG');
        const canvas = await page.evaluate(() =>
            Array.from(document.getElementById('canvas').getContext('2d').getImageData(0, 0, 64, 36).data));
        equal(canvas.filter((_, index) => index % 4 !== 3).join(), numbers.join(), 'the pixels of the page');
    },

    async 'every picture has the digest of render-aos'({ open, url }) {
        await shoot(await pictures(open, url), 'last-picture');
    },

    async 'every picture has the digest of render-aos without 128-bit lanes'({ open }) {
        // The check for lanes becomes a text that is no module, so the page takes the other module.
        const old = await serve((name, bytes) =>
            name.endsWith('.js') ? bytes.toString().replace(/WebAssembly\.validate\(\w+\)/, 'false') : bytes);
        const page = await pictures(open, old.url);
        equal(await page.evaluate(() => document.documentElement.dataset.instructionSet), 'portable', 'the module');
        old.close();
    },

    async 'a picture that is wider than a canvas is shown in part and saved whole'({ open, url }) {
        const page = await open(url);
        await digest(page);
        const scene = 'matte: grey .5 .5 .5\nsphere: 0 0 0 4 grey\n';
        await render(page, { config: 'image_width: 9000\naspect_ratio: 9000 7\nsamples_per_pixel: 1\n', scene });
        check((await page.textContent('#status')).includes('one pixel in 3'), await page.textContent('#status'));
        equal(await page.evaluate(() => document.getElementById('canvas').width), 3000, 'the canvas');
        const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-ppm')]);
        check(readFileSync(await download.path()).toString().startsWith('P3\n9000 7\n255\n'), 'the whole picture');
    },

    async 'a worker that cannot be loaded is a message'({ open, url, browser, faults }) {
        const context = await browser.newContext();
        await context.route(/(preparing|worker)\.js$/, (route) => route.abort());
        const page = await open(url, { context });
        const says = (id, words) => page.waitForFunction(([name, text]) =>
            document.getElementById(name).textContent.includes(text), [id, words]);
        await says('config-faults', 'could not be loaded: preparing.js');
        await page.click('#tab-live');
        await says('live-status', 'could not be loaded: preparing.js');
        await page.evaluate(() => setTimeout(() => { throw new Error('an odd exception'); }));
        await says('said', 'an odd exception');
        // The browser reports each script that it does not get, and the exception.
        const reported = /ERR_FAILED|an odd exception/;
        faults.splice(0, faults.length, ...faults.filter((fault) => !reported.test(fault)));
    },

    async 'too little memory is a message and the page goes on'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'config', 'image_width: 1000000000\naspect_ratio: 1000000000 1\n');
        await page.click('#render');
        await page.waitForFunction(() => document.getElementById('status').textContent.includes('Not enough memory'));
        check((await digest(page, 1000).catch(() => 'none')) === 'none', 'there is no picture');
        check((await pixels(page, 'canvas')).bytes.every((byte) => byte === 0), 'the one of the earlier texts is removed');
        check((await render(page, SMALL)).length === 64, 'the next picture is rendered');
    },
};
