// Tests of the editors: errors, completion, examples.
import { check, checkPauses, completionsTakeKeys, digest, equal, shoot, SMALL, textOf, type, watchPauses } from './tools.mjs';

export const tests = {
    async 'an error stands at its line in the words of the renderer'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'config', 'gamma: 2\n\nimage_widht: 3\n\nmax_depth: 0\n');
        await page.waitForSelector('#config-editor .cm-lintRange-error');
        equal(await page.textContent('#config-editor .cm-lintRange-error'), 'image_widht:', 'the marked word');
        const unknown = 'Unknown configuration key: [image_widht:]\nthere is no configuration key [image_widht:]; did you mean [image_width:]?';
        equal(await page.locator('#config-faults pre').first().textContent(), unknown, 'the message');
        equal((await page.locator('#config-faults button').allTextContents()).join(), 'Line 3,Line 5', 'the lines');
        await page.selectOption('#language', 'es');
        await page.waitForFunction(() => document.querySelector('#config-faults pre').textContent.endsWith('¿quería decir [image_width:]?'));
        check((await page.textContent('#config-faults pre')).startsWith('Los programas dicen: Unknown'), 'whose words they are');
        await page.selectOption('#language', 'en');
        equal(await page.locator('#config-editor .cm-lintRange-error').count(), 2, 'the marks');
        await type(page, 'scene', 'matte: grey .5 .5 .5\nsphere: 0 0 0 -4 grey\n');
        await page.waitForSelector('#scene-editor .cm-lintRange-error');
        equal(await page.textContent('#scene-editor .cm-lintRange-error'), '-4', 'the wrong number');
        const message = 'Invalid sphere parameters\nLine: "sphere: 0 0 0 -4 grey"\n'
            + 'sphere: [-4] is not a number above 0; the line is: sphere: x y z radius material';
        equal(await page.textContent('#scene-faults pre'), message, 'the message about the scene');
        await shoot(page, 'errors');
        await page.click('#render');
        await page.waitForFunction(() => document.getElementById('status').textContent.includes('in: Configuration, Scene.'));
        await page.click('#scene-faults button');
        await page.keyboard.press('Delete');
        await page.waitForFunction(() => document.querySelector('#scene-faults').childElementCount === 0);
        await page.waitForFunction(() => document.getElementById('old').textContent.startsWith('There is an error in: Configuration.'));
        equal(await textOf(page, 'scene'), 'matte: grey .5 .5 .5\nsphere: 0 0 0 4 grey\n', 'the cursor was at the fault');
    },

    async 'numbers change by dragging with Alt, and colours by a picker'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await type(page, 'config', 'image_width: 320\nbackground_dark_color: 0 .5 1');
        await type(page, 'scene', 'matte: grey 0.5 .5 .5\nsphere: 0 -4 0 4 grey');
        const drag = async (editor, row, number, pixels) => {
            const box = await page.locator(`#${editor}-editor .cm-line:nth-child(${row}) .number`).nth(number).boundingBox();
            const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
            await page.mouse.move(x, y);
            await page.keyboard.down('Alt');
            await page.mouse.down();
            await page.mouse.move(x + pixels / 2, y);
            await page.mouse.move(x + pixels, y);
            await page.mouse.up();
            await page.mouse.move(x, y);
            await page.keyboard.up('Alt');
        };
        const becomes = (editor, text) => page.waitForFunction(([name, expected]) =>
            JSON.parse(localStorage.getItem('render.texts'))[name] === expected, [editor, text]);
        await drag('config', 1, 0, -40);
        await becomes('config', 'image_width: 300\nbackground_dark_color: 0 .5 1');
        await drag('scene', 2, 1, 60);
        await becomes('scene', 'matte: grey 0.5 .5 .5\nsphere: 0 -3.70 0 4 grey');
        await page.locator('#scene-editor .cm-line:nth-child(2) .number').nth(1).click();
        for (const key of ['Up', 'Up', 'Up', 'Down']) {
            await page.keyboard.press(`Alt+Arrow${key}`);
        }
        await becomes('scene', 'matte: grey 0.5 .5 .5\nsphere: 0 -3.68 0 4 grey');
        await page.keyboard.press('Control+z');
        await becomes('scene', 'matte: grey 0.5 .5 .5\nsphere: 0 -3.70 0 4 grey');
        equal(await page.inputValue('#scene-editor .square'), '#bababa', 'the light .5 has the byte 186');
        const pick = (editor, color) => page.evaluate(([name, value]) => {
            const input = document.querySelector(`#${name}-editor .square`);
            input.value = value;
            input.dispatchEvent(new Event('input'));
        }, [editor, color]);
        await pick('scene', '#ff8000');
        // (128 / 255)^2.2 is 0.2195.
        await becomes('scene', 'matte: grey 1 0.22 0\nsphere: 0 -3.70 0 4 grey');
        equal(await page.inputValue('#scene-editor .square'), '#ff8000', 'the picked colour');
        await pick('config', '#000000');
        await becomes('config', 'image_width: 300\nbackground_dark_color: 0 0 0');
        await page.click('#scene-editor .cm-content');
        await page.keyboard.press('Control+z');
        await becomes('scene', 'matte: grey 0.5 .5 .5\nsphere: 0 -3.70 0 4 grey');
        await shoot(page, 'squares');
    },

    async 'a finger changes the number that it has tapped'({ open, url }) {
        const page = await open(url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
        await digest(page);
        await type(page, 'scene', SMALL.scene);
        await page.tap('#scene-editor .cm-line:nth-child(2) .number >> nth=3');
        const box = await page.locator('#scene-editor .turn').boundingBox();
        check(box.height >= 28 && box.width >= 40, `the handle has ${box.width} x ${box.height} pixels`);
        const session = await page.context().newCDPSession(page);
        const touch = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
        const at = (shift) => [{ x: box.x + box.width / 2 + shift, y: box.y + box.height / 2 }];
        const scrolled = await page.evaluate(() => scrollY);
        await touch('touchStart', at(0));
        for (const shift of [10, 20, 40]) {
            await touch('touchMove', at(shift));
        }
        await touch('touchEnd', []);
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).scene.includes('sphere: 0 0 0 4.20 grey'));
        equal(await page.evaluate(() => scrollY), scrolled, 'the place to which the page is scrolled');
        await shoot(page, 'phone-number');
    },

    async 'a picture that cannot be made is an error of the configuration'({ open, url }) {
        const page = await open(url);
        await type(page, 'config', 'camera_target: 0 0 -10\n');
        await page.waitForSelector('#config-faults pre');
        const message = await page.textContent('#config-faults pre');
        check(message.startsWith('Invalid configuration: camera_position is the same point'), message);
    },

    async 'keys are completed with values, default and meaning'({ open, url }) {
        const page = await open(url);
        await type(page, 'config', '');
        await page.keyboard.type('sam');
        await page.waitForSelector('.cm-tooltip-autocomplete');
        const option = await page.textContent('.cm-tooltip-autocomplete li[aria-selected]');
        check(option.includes('samples_per_pixel:') && option.includes('whole number > 0'), option);
        const info = await page.textContent('.cm-completionInfo');
        equal(info, 'rays a pixel; noise falls with their square root; default: 20', 'the meaning of the table');
        equal(await page.locator('.cm-completionIcon').count(), 0, 'icons, which are empty boxes where no font has them');
        await shoot(page, 'completion');
        await completionsTakeKeys(page);
        await page.keyboard.press('Enter');
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).config === 'samples_per_pixel: 20');
        // The rest of a line stays, behind a blank.
        await type(page, 'config', '40');
        await page.keyboard.press('Home');
        await page.keyboard.type('sam');
        await page.waitForSelector('.cm-tooltip-autocomplete');
        await completionsTakeKeys(page);
        await page.keyboard.press('Enter');
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).config === 'samples_per_pixel: 40');
        await type(page, 'config', '');
        await page.keyboard.press('Control+Space');
        await page.waitForSelector('.cm-tooltip-autocomplete');
        equal(await page.locator('.cm-tooltip-autocomplete li').count(), 13, 'all keys are offered');
    },

    async 'the materials above a line are completed'({ open, url }) {
        const page = await open(url);
        await type(page, 'scene', 'matte: grey .5 .5 .5\nmetal: gold 1 1 1 0\nsphere: 0 0 0 1 ');
        await page.keyboard.type('g');
        await page.waitForSelector('.cm-tooltip-autocomplete');
        const options = await page.locator('.cm-tooltip-autocomplete .cm-completionLabel').allTextContents();
        equal(options.sort().join(), 'gold,grey', 'both materials');
        await page.keyboard.type('rey');
        await page.waitForSelector('.cm-tooltip-autocomplete', { state: 'detached' });
        await page.keyboard.press('Enter');
        equal(await page.locator('#scene-editor .cm-line').count(), 4, 'Enter after a whole name begins a line');
    },

    async 'every example is loaded and can be undone'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await page.waitForFunction(() => document.getElementById('examples').length > 1);
        const names = await page.locator('#examples option').allTextContents();
        equal(names.slice(1).join(), 'cylinders,grid,listings,materials,spheres,ten-thousand', 'the folders of scenes/');
        const has = (wanted) => page.waitForFunction((texts) => {
            const { config, scene } = JSON.parse(localStorage.getItem('render.texts'));
            return config === texts.config && scene === texts.scene;
        }, wanted);
        const first = { config: await textOf(page, 'config'), scene: await textOf(page, 'scene') };
        await page.click('#scene-editor .cm-content');
        await page.keyboard.press('Control+z');
        await has(first);
        await type(page, 'config', SMALL.config);
        await type(page, 'scene', SMALL.scene);
        await page.selectOption('#examples', 'listings');
        await page.waitForFunction(() => JSON.parse(localStorage.getItem('render.texts')).scene.startsWith('matte: mat1'));
        const example = { config: await textOf(page, 'config'), scene: await textOf(page, 'scene') };
        await page.click('#scene-editor .cm-content');
        await page.keyboard.press('Control+z');
        await has(SMALL);
        await page.click('#config-editor .cm-content');
        await page.keyboard.press('Control+y');
        await has(example);
    },

    async 'six million blanks are inserted and checked while the page answers'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await watchPauses(page);
        await type(page, 'scene', `${`${' '.repeat(999)}\n`.repeat(6000)}sphere: 0\n`);
        await page.waitForSelector('#scene-faults pre');
        equal(await page.textContent('#scene-faults button'), 'Line 6001', 'the line of the fault');
        await page.waitForTimeout(300);
        await checkPauses(page);
    },
};
