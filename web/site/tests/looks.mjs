// Tests of small screens, the keyboard, colours and languages.
import { openLive, SCENE } from './live.mjs';
import { edit } from './shaders.mjs';
import { check, completionsTakeKeys, digest, equal, frame, shoot } from './tools.mjs';

/**
 * Returns the contrast of an element's text with its background, as WCAG defines it. The faint colour of the line with
 * the cursor is left out.
 */
const contrast = (page, selector) => page.evaluate((name) => {
    const luminance = (colour) => {
        const [red, green, blue] = colour.match(/[\d.]+/g).map(Number)
            .map((channel) => channel / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    };
    let element = document.querySelector(name);
    const text = luminance(getComputedStyle(element).color);
    while (!getComputedStyle(element).backgroundColor.startsWith('rgb(')) {
        element = element.parentElement;
    }
    const back = luminance(getComputedStyle(element).backgroundColor);
    return (Math.max(text, back) + 0.05) / (Math.min(text, back) + 0.05);
}, selector);

const PARTS = ['h1', 'header p', '#config-editor .cm-content', '#config-editor .tag', '#config-editor .number',
    '#scene-editor .name', '#config-editor .cm-gutters', '#render', '#share', '#status', '.help'];

export const tests = {
    async 'a phone of 390 pixels shows the whole width'({ open, url }) {
        const page = await open(url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
        await digest(page);
        await page.tap('#share');
        await page.waitForFunction(() => document.getElementById('link').value !== '');
        const [needed, width] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
        equal(`${needed} ${width}`, '390 390', 'the needed width and that of the screen');
        const small = await page.evaluate(() => Array.from(document.querySelectorAll('button, select'))
            .filter((one) => one.offsetParent && one.offsetHeight < 40).map((one) => one.id || one.textContent));
        equal(small.join(), '', 'elements that are too small to touch');
        const box = await page.locator('#canvas').boundingBox();
        equal(await page.evaluate(() => scrollY), 0, 'the place to which the page is scrolled');
        check(box.y > 0 && box.y + box.height < 500, `the picture is from ${box.y} to ${box.y + box.height}`);
        check(await page.isVisible('.touch') && !await page.isVisible('.keys'), 'the hints are those for fingers');
        const fine = await page.evaluate(() => Array.from(document.querySelectorAll('input, select, .cm-content'))
            .filter((one) => parseFloat(getComputedStyle(one).fontSize) < 16).map((one) => one.id || one.className));
        equal(fine.join(), '', 'inputs whose letters are smaller than 16 px, into which phones zoom');
        await page.evaluate(() => document.getElementById('render').scrollIntoView());
        await page.tap('#render');
        const tabs = await page.locator('.tabs').boundingBox();
        check(tabs.y > -1, `the picture comes into sight, the tabs at ${tabs.y}`);
        await digest(page);
        await shoot(page, 'phone');
    },

    async 'the editors fill the window, and the picture and the sliders stay in sight'({ open, url }) {
        for (const [width, height, least] of [[1280, 800, 24], [1920, 1080, 38]]) {
            const page = await openLive(open, url, SCENE, { viewport: { width, height } });
            const boxes = (...names) => Promise.all(names.map((name) => page.locator(name).boundingBox()));
            const [config, scene, summary] = await boxes('#config-editor', '#scene-editor', '#shader-summary');
            const lines = (config.height + scene.height) / 21;
            check(lines > least, `the editors have ${lines} lines`);
            check(summary.y + summary.height > height - 30, `the column ends at ${summary.y + summary.height}`);
            const [bar] = await boxes('#bar-editors');
            await page.mouse.move(bar.x + 50, bar.y + 3);
            await page.mouse.down();
            await page.mouse.move(bar.x + 50, bar.y + 103, { steps: 3 });
            await page.mouse.up();
            await page.focus('#bar-columns');
            await page.keyboard.press('ArrowRight');
            const [moved] = await boxes('#config-editor');
            const [higher, wider] = [moved.height - config.height, moved.width - config.width];
            check(Math.abs(higher - 100) < 40 && wider > 10, `the editor is ${higher} higher and ${wider} wider`);
            await page.reload();
            await digest(page);
            equal(JSON.stringify(await boxes('#config-editor')), JSON.stringify([moved]), 'the editor keeps its size');
            await page.click('#tab-live');
            await page.click('#shader-part summary');
            const name = 'fn background_color';
            await edit(page, name, `override gain: f32 = 0.5; // slider 0..2 step .25\n${name}`);
            await page.waitForSelector('#knobs input');
            const [editor, picture, knobs] = await boxes('#shader-editor', '#live-canvas', '#knobs');
            check(picture.y > 0 && picture.y + picture.height < height, `the picture is at ${picture.y}`);
            check(knobs.x > editor.x + editor.width, 'the sliders are in the column of the picture');
            check(knobs.y > 0 && knobs.y < height, `the sliders are at ${knobs.y}`);
            await shoot(page, `wide-${width}`);
        }
    },

    async 'the help of each view and a link are in sight in a low window'({ open, url }) {
        for (const language of ['en', 'es']) {
            const page = await openLive(open, url, SCENE, { viewport: { width: 1366, height: 650 } });
            await page.selectOption('#language', language);
            for (const [name, ready] of [['live', '#live-axes:not(:empty)'], ['compare', '#compare-figures[data-differing]']]) {
                await page.click(`#tab-${name}`);
                await page.waitForSelector(ready);
                const { y, height } = await page.locator(`#${name}-help`).boundingBox();
                check(height > 30 && y + height <= 650, `the help of ${name} in ${language} ends at ${y + height}`);
                await shoot(page, `low-${name}-${language}`);
            }
            await page.click('#tab-exact');
            await page.click('#share');
            await page.waitForFunction(() => document.getElementById('link').value !== '');
            const link = await page.locator('#link').boundingBox();
            check(link.y + link.height < 651, `the link in ${language} ends at ${link.y + link.height}`);
        }
    },

    async 'everything is reached with the keyboard'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await page.waitForFunction(() => document.getElementById('examples').length > 1);
        const reached = [];
        await page.evaluate(() => document.activeElement.blur());
        for (let step = 0; step < 32; step++) {
            await page.keyboard.press('Tab');
            const name = await page.evaluate(() => {
                const here = document.activeElement;
                return here.id || here.closest('.editor')?.id || '';
            });
            if (name === '' || name === reached[0]) {
                break;
            }
            // An editor shows its ring a moment after it has the focus.
            await page.waitForFunction(() => {
                const here = document.activeElement;
                return getComputedStyle(here.closest('.cm-editor') ?? here).outlineStyle !== 'none';
            });
            reached.push(name);
        }
        const expected = 'open,examples,language,config-fold,config-save,config-editor,bar-editors,scene-fold,scene-save,scene-editor,files-link,'
            + 'shader-summary,bar-columns,tab-exact,full,render,save-ppm,save-png,exact-view,exposure,exact-stage,exact-stage-fit,'
            + 'exact-stage-actual,live,share';
        equal(reached.join(), expected, 'the order of the keyboard');
        await page.focus('#examples');
        await page.keyboard.press('l');
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).config.includes('1200'));
    },

    async 'all views fit every width, in dark and light, in both languages'({ open, url }) {
        const page = await openLive(open, url);
        const all = (list, others) => list.flatMap((one) => others.map((other) => [one, other].flat()));
        for (const [colorScheme, language, width] of all(['light', 'dark'], all(['en', 'es'], [390, 1280, 1920]))) {
            await page.setViewportSize({ width, height: width === 390 ? 844 : 800 });
            await page.emulateMedia({ colorScheme });
            await page.selectOption('#language', language);
            const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
            equal(back, colorScheme === 'light' ? 'rgb(251, 251, 250)' : 'rgb(23, 24, 27)', colorScheme);
            for (const [tab, ready] of [['exact', '#digest code'], ['live', '#live-status'], ['compare', '#compare-most-at'], ['pixel', '#pixel-steps .head'], ['explain', '#explain-steps .part']]) {
                const name = `${tab}-${width}-${colorScheme}-${language}`;
                await page.click(`#tab-${tab}`);
                await page.waitForSelector(ready, { state: 'attached' });
                equal(await page.evaluate(() => document.documentElement.scrollWidth), width, `the width of ${name}`);
                const cut = await page.evaluate(() => Array.from(document.querySelectorAll('button, label, p, h1, h2, pre'))
                    .filter((one) => one.offsetParent && one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0)
                    .map((one) => one.id || one.textContent));
                equal(cut.join(), '', `what is cut off in ${name}`);
                await shoot(page, name);
            }
            for (const part of PARTS) {
                const found = await contrast(page, part);
                check(found >= 4.5, `${part} in ${colorScheme}: ${found}`);
            }
        }
    },

    async 'the page speaks Spanish where the browser does, and on request'({ open, url }) {
        const page = await open(url, { locale: 'es-ES' });
        await digest(page);
        equal(await page.textContent('#render'), 'Renderizar', 'the button');
        equal(await page.getAttribute('html', 'lang'), 'es', 'the language');
        check((await page.textContent('#digest')).endsWith('los bytes de render-aos'), 'the words');
        await page.click('#config-editor .cm-content');
        await page.keyboard.press('Control+Home');
        await page.keyboard.type('ga');
        await page.waitForSelector('.cm-completionInfo');
        const info = await page.textContent('.cm-completionInfo');
        check(info.startsWith('corrección gamma') && info.endsWith('por defecto: 2.2'), info);
        await shoot(page, 'spanish');
        await page.keyboard.press('Escape');
        await page.keyboard.press('Control+f');
        equal(await page.textContent('.cm-search [name=next]'), 'siguiente', 'the words of the find box');
        check(await contrast(page, '.cm-search [name=next]') >= 4.5, 'the find box has the colours of the page');
        await shoot(page, 'find');
        await page.click('#share');
        await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('El enlace'));
        await page.selectOption('#language', 'en');
        equal(await page.textContent('#render'), 'Render', 'the button in English');
        check(/^The link/.test(await page.textContent('#status')), 'the message follows the language');
        check((await page.textContent('#digest')).endsWith('the bytes of render-aos'), 'the words of the digest');
        await page.reload();
        await page.waitForSelector('#config-faults pre');
        equal(await page.textContent('#render'), 'Render', 'the choice is kept');
    },

    async 'every line of the tables has a meaning in Spanish'({ open, url }) {
        const page = await open(url, { locale: 'es-ES' });
        await digest(page);
        let compared = 0;
        for (const [editor, count] of [['config', 13], ['scene', 5]]) {
            await page.click(`#${editor}-editor .cm-content`);
            await page.keyboard.press('Control+Home');
            await page.keyboard.press('Control+Space');
            await page.waitForSelector('.cm-tooltip-autocomplete');
            equal(await page.locator('.cm-tooltip-autocomplete li').count(), count, 'the lines that are offered');
            const values = (await page.locator('.cm-completionDetail').allTextContents()).join();
            check(!/\b(numbers?|in|name|index|radius)\b/.test(values), values);
            await completionsTakeKeys(page);
            let info = '';
            for (let index = 0; index < count; index++) {
                // All meanings differ, so another text is that of the next line.
                await page.waitForFunction((last) => ![last, undefined].includes(document.querySelector('.cm-completionInfo')?.textContent), info);
                info = await page.textContent('.cm-completionInfo');
                check(!/\b(the|width|with|seed|background|material defined)\b/.test(info), info);
                compared += 1;
                await page.keyboard.press('ArrowDown');
            }
            await page.keyboard.press('Escape');
        }
        equal(compared, 18, 'the compared lines');
    },

    async 'all views fit a phone, and are readable in the dark and in Spanish'({ open, url }) {
        const page = await openLive(open, url, SCENE, {
            viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, locale: 'es-ES', colorScheme: 'dark' });
        await page.tap('#shader-part summary');
        for (const [tab, ready] of [['live', '#live-status'], ['compare', '#compare-figures'], ['pixel', '#pixel-column']]) {
            await page.tap(`#tab-${tab}`);
            await page.waitForSelector(ready);
            if (tab === 'compare') {
                await page.waitForFunction(() => /RMSE/.test(document.getElementById('compare-figures').textContent));
                await shoot(page, 'phone-figures');
                await page.selectOption('#compare-view', 'ulps');
                const legend = await page.locator('#compare-legend').boundingBox();
                check(legend.width > 90, 'the colours of the scale are seen');
                await page.evaluate(() => scrollTo(0, 150));
                await page.tap('#compare-stage');
                await page.waitForSelector('#pixel-steps tr');
                const { y } = await page.locator('.tabs').boundingBox();
                check(y > -1, `the start of the next view is in sight, at ${y}`);
            }
            equal(await page.evaluate(() => document.documentElement.scrollWidth), 390, `the width of ${tab}`);
            const small = await page.evaluate(() => Array.from(document.querySelectorAll('button, select'))
                .filter((one) => one.offsetParent && one.offsetHeight < 40 && !one.closest('.cm-editor'))
                .map((one) => one.id || one.textContent));
            equal(small.join(), '', 'elements that are too small to touch');
            if (tab === 'pixel') {
                const column = await page.locator('#pixel-steps thead td').last().boundingBox();
                check(column.x + column.width <= 391, `the column of WGSL ends at ${column.x + column.width}`);
            }
            await shoot(page, `phone-${tab}`);
        }
        for (const part of ['#pixel-steps td', '#pixel-first', '#shader-editor .cm-content', '#shader-editor .comment', '#tab-live', '#tab-pixel']) {
            const found = await contrast(page, part);
            check(found >= 4.5, `${part}: ${found}`);
        }
        const empty = await page.evaluate(() => Array.from(document.querySelectorAll('[data-words]'))
            .filter((one) => one.textContent.trim() === '').map((one) => one.dataset.words));
        equal(empty.join(), '', 'words without a text');
        equal(await page.textContent('#tab-compare'), 'Comparar', 'the language');
    },

    async 'the tabs are moved by the arrow keys'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await page.focus('#tab-exact');
        await page.keyboard.press('ArrowRight');
        equal(await page.getAttribute('#tab-live', 'aria-selected'), 'true', 'the next tab');
        await frame(page);
        check(await page.isVisible('#live-canvas') && !await page.isVisible('#canvas'), 'one view is shown');
        // The button for the full screen and two of the live view stand before the picture.
        for (const name of ['full', 'live-take', 'live-reset', 'live-canvas']) {
            await page.keyboard.press('Tab');
            equal(await page.evaluate(() => document.activeElement.id), name, 'the element with the focus');
        }
        await page.focus('#tab-live');
        await page.keyboard.press('ArrowLeft');
        check(await page.isVisible('#canvas'), 'the first view is shown again');
    },
};
