// Tests of the view that explains a pixel of the exact picture.
import { check, digest, equal, pixels, render, shoot, SMALL } from './tools.mjs';

/** Returns what the view says about its bytes, when it has a table. */
async function told(page) {
    await page.waitForFunction(() => document.querySelectorAll('#explain-steps tr').length > 8);
    return page.textContent('#explain-said');
}

/** Types a number, and waits for another table. */
async function choose(page, input, value) {
    await page.evaluate(() => document.getElementById('explain-steps').replaceChildren());
    await page.focus(`#explain-${input}`);
    await page.keyboard.press('Control+a');
    await page.keyboard.type(`${value}\n`);
    return told(page);
}

export const tests = {
    async 'explain tells the steps of each sample, and arrives at the bytes of the picture'({ open, url }) {
        const page = await open(url);
        await digest(page);
        await render(page, SMALL);
        const { bytes } = await pixels(page, 'canvas');
        const requests = [];
        page.on('request', (request) => requests.push(request.url()));
        await page.click('#exact-stage', { position: { x: 5, y: 5 } });
        await page.click('#tab-explain');
        await told(page);
        equal(await page.inputValue('#explain-column') + await page.inputValue('#explain-row'), '00', 'the clicked pixel');
        check(requests.some((request) => request.endsWith('explain.wasm')), `its module comes when it is needed: ${requests}`);
        for (const [column, row] of [[32, 18], [0, 35], [63, 20], [30, 19]]) {
            await choose(page, 'column', column);
            const said = await choose(page, 'row', row);
            const at = 3 * (64 * row + column);
            equal(said, `Bytes ${bytes.slice(at, at + 3).join(' ')}, as in the picture.`, `${column} ${row}`);
        }
        const steps = () => page.innerText('#explain-steps');
        const first = await steps();
        check(/^offset\s+x = -?0\.\d+, y = -?0\.\d+: draws [\d,]+ and [\d,]+ of the rays\nQ\s/.test(first), first);
        check(/\nsphere, line 2\s+sphere: lambda [\d.]+ counts\n/.test(first), first);
        check(/\nmatte\s+sends a ray along \(.*\nbytes\s+\d+ \d+ \d+$/s.test(first), first);
        await shoot(page, 'explain');
        await page.click('#explain-steps a');
        equal(await page.evaluate(() => document.activeElement.closest('.editor')?.id), 'scene-editor', 'the line of the object');
        await choose(page, 'sample', 1);
        check(await steps() !== first, 'the steps of another sample');
        check(/^Sample \(0 to \d+\)$/.test(await page.textContent('#explain-sample >> xpath=../span')), 'the number of samples');
        await page.selectOption('#language', 'es');
        check((await page.textContent('#explain-said')).endsWith(', como en la imagen.'), 'the words in Spanish');
        check(/\ndesde\s/.test(await steps()), await steps());
        await page.selectOption('#language', 'en');
        await page.click('#share');
        await page.waitForFunction(() => document.getElementById('link').value !== '');
        const other = await open(await page.inputValue('#link'));
        await told(other);
        equal(await other.inputValue('#explain-column') + await other.inputValue('#explain-row'), '3019', 'the pixel of a link');
    },
};
