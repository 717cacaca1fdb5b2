// Tests that nothing of what the user types is lost, and of links.
import { openLive, SCENE } from './live.mjs';
import { edit, moduleText } from './shaders.mjs';
import { check, digest, equal, frame, pixels, render, rmse, shoot, SMALL, still, textOf, type } from './tools.mjs';

const BROKEN = 'matte: grey .5 .5\nthis is no scene';

export const tests = {
    async 'a broken scene is still there when the page is loaded again'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'scene', BROKEN);
        // The page is left before the pause after which it keeps the text.
        await page.reload();
        await page.waitForSelector('#scene-faults pre');
        equal(await textOf(page, 'scene'), BROKEN, 'the kept scene');
        const lines = await page.locator('#scene-editor .cm-line').allTextContents();
        equal(lines.join('\n'), BROKEN, 'the scene in the editor');
    },

    async 'typed texts that an example replaces are among the earlier texts'({ open, url }) {
        const page = await open(url);
        await digest(page);
        check(await page.isDisabled('#earlier'), 'there are none at first');
        await type(page, 'scene', BROKEN);
        await page.waitForSelector('#scene-faults pre');
        await page.selectOption('#examples', 'listings');
        await page.waitForFunction(() => document.getElementById('earlier').length === 2);
        await page.selectOption('#examples', 'cylinders');
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).scene.includes('cylinder:'));
        equal(await page.locator('#earlier option').count(), 2, 'an example is no typed text');
        const earlier = await page.locator('#earlier option').last().textContent();
        check(/: 0 objects, 480 px$/.test(earlier), earlier);
        // Dates have the language of the page, and in English the way of the British browser.
        const date = async () => (await page.locator('#earlier option').last().textContent()).split(': ')[0];
        const at = await page.evaluate(() => JSON.parse(localStorage.getItem('render.earlier'))[0].time);
        for (const [language, locale] of [['es', 'es'], ['en', 'en-GB']]) {
            await page.selectOption('#language', language);
            const told = await page.evaluate(([time, name]) => new Date(time).toLocaleString(name), [at, locale]);
            equal(await date(), told, `the date in ${locale}`);
        }
        await page.selectOption('#earlier', '0');
        await page.waitForSelector('#scene-faults pre');
        equal(await textOf(page, 'scene'), BROKEN, 'the earlier scene');
    },

    async 'a link has both texts, and the typed ones stay among the earlier texts'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'config', SMALL.config);
        await type(page, 'scene', SMALL.scene);
        await page.keyboard.press('Control+Enter');
        await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('64'));
        const picture = await digest(page);
        await page.click('#share');
        await page.waitForFunction(() => document.getElementById('link').value !== '');
        const link = await page.inputValue('#link');
        check(link.startsWith(`${url}#2:`) && link.length < 400, link);
        await shoot(page, 'link');
        const other = await open(link);
        equal(await digest(other), picture, 'the picture of the link');
        equal(await textOf(other, 'config'), SMALL.config, 'the configuration of the link');
        equal(other.url(), url, 'the address without the texts');

        const third = await open(url, { context: page.context() });
        await digest(third);
        await type(third, 'scene', BROKEN);
        await third.waitForSelector('#scene-faults pre');
        await third.goto(link.replace('#', '?again#'));
        equal(await digest(third), picture, 'the picture of the link');
        equal(await third.locator('#earlier option').count(), 2, 'the typed texts are kept');
    },

    async 'Back and Forward bring the scene of an entry back, its typed texts and its view'({ open, url }) {
        const page = await openLive(open, url);
        await page.focus('#live-canvas');
        await page.keyboard.press('ArrowRight');
        await type(page, 'config', `${SCENE.config}max_depth: 3\n`);
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).config.includes('max_depth'));
        await still(page);
        const seen = await pixels(page, 'live-canvas');
        const shows = async (move, config, tab) => {
            await move();
            await page.waitForFunction((text) => JSON.parse(localStorage.getItem('render.texts')).config === text, config);
            await page.waitForSelector(`#tab-${tab}[aria-selected=true]`);
            await digest(page);
            equal(page.url().includes('#'), false, 'the texts are not in the address');
            if (tab === 'live') {
                await page.check('#live-fixed');
                await still(page);
                equal(rmse((await pixels(page, 'live-canvas')).bytes, seen.bytes), 0, 'the picture');
            }
        };
        await render(page, SMALL);
        await page.click('#tab-exact');
        const twice = async (move) => { await move(); await move(); };
        await shows(() => twice(() => page.goBack()), `${SCENE.config}max_depth: 3\n`, 'live');
        await shows(() => twice(() => page.goForward()), SMALL.config, 'exact');
        // Another address loads the page again.
        await page.click('#share');
        await page.waitForFunction(() => document.getElementById('link').value !== '');
        await shows(() => twice(() => page.goBack()), `${SCENE.config}max_depth: 3\n`, 'live');
        await page.goto(`${url}?again${new URL(await page.inputValue('#link')).hash}`);
        await digest(page);
        await shows(() => page.goBack(), `${SCENE.config}max_depth: 3\n`, 'live');
    },

    async 'Back goes through tabs and examples, and never leaves the page while a text is not saved'({ open, url }) {
        const page = await open(url);
        await digest(page);
        const first = await textOf(page, 'scene');
        const has = (text) => page.waitForFunction((scene) => JSON.parse(localStorage.getItem('render.texts')).scene === scene, text);
        await type(page, 'scene', SMALL.scene);
        await has(SMALL.scene);
        for (let times = 0; times < 3; times++) {
            await page.goBack().catch(() => null);
            await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('Your text is not saved'));
            equal(page.url(), url, 'the page stays');
            await has(SMALL.scene);
        }
        // The end of a picture does not replace the message.
        await page.evaluate(() => document.getElementById('digest').replaceChildren());
        await type(page, 'config', 'image_width: 320\nsamples_per_pixel: 400\n');
        await page.click('#render');
        await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('Rendering'));
        await page.goBack().catch(() => null);
        await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('Your text is not saved'));
        check(await page.isVisible('#bar'), 'the picture is not finished');
        await digest(page);
        check((await page.textContent('#status')).startsWith('Your text is not saved'), await page.textContent('#status'));
        await page.click('#tab-live');
        await page.selectOption('#examples', 'listings');
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).scene.startsWith('matte: mat1'));
        await page.goBack();
        await has(SMALL.scene);
        equal(await page.getAttribute('#tab-live', 'aria-selected'), 'true', 'the tab of that entry');
        await page.keyboard.press('Escape');
        await type(page, 'scene', `${SMALL.scene}\n`);
        await has(`${SMALL.scene}\n`);
        await page.goBack();
        await page.waitForSelector('#tab-exact[aria-selected=true]');
        await has(`${SMALL.scene}\n`);
        check(first !== SMALL.scene, 'the text was another one');
        // A text that is saved, here by a download, may be left.
        await Promise.all([page.waitForEvent('download'), page.click('#config-save')]);
        const [saved] = await Promise.all([page.waitForEvent('download'), page.click('#scene-save')]);
        equal(saved.suggestedFilename(), 'scene.txt', 'the name of the file');
        await page.goBack().catch(() => null);
        await page.waitForURL('about:blank');
    },

    async 'text files are opened by a button or dropped, and go to their editors'({ open, url }) {
        const page = await open(url);
        await digest(page);
        const drop = (names) => page.evaluate((files) => {
            const dataTransfer = new DataTransfer();
            files.forEach(([name, text]) => dataTransfer.items.add(new File([text], name)));
            // A scene that is dropped on the other editor goes to its own one.
            document.querySelector('#config-editor .cm-content').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
        }, names);
        const have = (config, scene) => page.waitForFunction(([one, other]) => {
            const texts = JSON.parse(localStorage.getItem('render.texts'));
            return texts.config === one && texts.scene === other;
        }, [config, scene]);
        const config = await textOf(page, 'config');
        await drop([['scene.txt', SMALL.scene]]);
        await have(config, SMALL.scene);
        // Without a telling name the lines decide.
        await drop([['a.txt', 'image_width: 33\n'], ['balls.txt', `${SMALL.scene}\n`]]);
        await have('image_width: 33\n', `${SMALL.scene}\n`);
        await digest(page);
        const [picture] = await Promise.all([page.waitForEvent('download'), page.click('#save-png')]);
        equal(picture.suggestedFilename(), 'balls.png', 'the name of the picture');
        // A line that is left keeps the name, and a wholly new text has none.
        for (const [scene, name] of [[`${SMALL.scene}sphere: 9 9 9 1 grey\n`, 'balls.png'],
            ['matte: red .9 .1 .1\nsphere: 0 0 0 3 red\n', 'picture.png']]) {
            await type(page, 'scene', scene);
            await have('image_width: 33\n', scene);
            await page.evaluate(() => document.getElementById('digest').replaceChildren());
            await page.click('#render');
            await digest(page);
            const [file] = await Promise.all([page.waitForEvent('download'), page.click('#save-png')]);
            equal(file.suggestedFilename(), name, 'the name of the picture of a changed scene');
        }
        await type(page, 'scene', `${SMALL.scene}\n`);
        await have('image_width: 33\n', `${SMALL.scene}\n`);
        await page.setInputFiles('#texts-files', { name: 'my-config.txt', mimeType: 'text/plain', buffer: Buffer.from(SMALL.config) });
        await have(SMALL.config, `${SMALL.scene}\n`);
        await page.click('#config-editor .cm-content');
        await page.keyboard.press('Control+z');
        await have('image_width: 33\n', `${SMALL.scene}\n`);
    },

    async 'a broken link leaves the texts and says so'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'scene', SMALL.scene);
        await page.waitForFunction((scene) => JSON.parse(localStorage.getItem('render.texts')).scene === scene, SMALL.scene);
        for (const fragment of ['#1:AAAA', '#1:%%', '#1:', '#2:AAAA', '#2:']) {
            await page.evaluate((text) => (location.hash = text), fragment);
            await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('The link could'));
            equal(await textOf(page, 'scene'), SMALL.scene, fragment);
            await page.evaluate(() => (document.getElementById('status').textContent = ''));
        }
        await page.goto(`${url}?again#1:AAAA`);
        await page.waitForFunction((scene) => document.querySelector('#scene-editor').textContent.includes(scene), 'sphere: 0 0 0 4 grey');
    },

    async 'a scene that is too large for the storage is rendered, and the page says so'({ open, url }) {
        const page = await open(url);
        await digest(page);
        // A browser keeps about five million characters for each site.
        const materials = Array.from({ length: 200_000 }, (_, number) => `matte: material-${number} .5 .5 .5\n`);
        await render(page, { ...SMALL, scene: SMALL.scene + materials.join('') });
        await page.click('#scene-editor .cm-content');
        await page.keyboard.type('\n');
        await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('This browser does not keep'));
        await page.click('#render');
        await digest(page);
    },

    async 'a link has the modules and the view, and own modules stay among the earlier texts'({ open, url }) {
        const page = await openLive(open, url);
        await page.click('#shader-part summary');
        const shown = await frame(page);
        await edit(page, 'background.light * (real(1.0) - m)', 'background.dark * (real(1.0) - m)');
        const edited = await frame(page, shown);
        await page.focus('#live-canvas');
        await page.keyboard.press('ArrowRight');
        await frame(page, edited);
        await still(page);
        const seen = await pixels(page, 'live-canvas');
        await page.click('#share');
        await page.waitForFunction(() => document.getElementById('link').value !== '');
        const link = await page.inputValue('#link');

        const other = await open(link);
        await other.check('#live-fixed');
        await frame(other);
        await still(other);
        equal(await other.getAttribute('#tab-live', 'aria-selected'), 'true', 'the live view is shown');
        equal(rmse((await pixels(other, 'live-canvas')).bytes, seen.bytes), 0, 'the view of the link');
        check((await moduleText(other)).includes('background.dark * (real(1.0) - m)'), 'the module of the link');
        equal(await other.textContent('#shader-changed'), 'changed: background', 'the page says that it is changed');

        const third = await openLive(open, url, SCENE);
        await third.click('#shader-part summary');
        await edit(third, '// The colour', '// mine\n// The colour');
        await third.waitForFunction(() => localStorage.getItem('render.modules')?.includes('mine'));
        await third.goto(link.replace('#', '?again#'));
        await frame(third);
        check(!(await moduleText(third)).includes('mine'), 'the module of the link');
        await third.selectOption('#earlier', '0');
        await third.waitForFunction(() => localStorage.getItem('render.modules').includes('mine'));
        check((await moduleText(third)).includes('// mine'), 'the own module is among the earlier texts');
    },
};
