// Tests that nothing of what the user types is lost, and of links.
import { check, digest, equal, render, shoot, SMALL, textOf, type } from './tools.mjs';

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
        check(link.startsWith(`${url}#1:`) && link.length < 300, link);
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

    async 'a broken link leaves the texts and says so'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'scene', SMALL.scene);
        await page.waitForFunction((scene) => JSON.parse(localStorage.getItem('render.texts')).scene === scene, SMALL.scene);
        for (const fragment of ['#1:AAAA', '#1:%%', '#1:']) {
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
};
