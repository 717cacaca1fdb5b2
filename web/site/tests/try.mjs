import { serve, browse, digest, shoot } from './tools.mjs';
const { url, close } = await serve();
await browse(async ({ open, faults, requests }) => {
    const t = Date.now();
    const page = await open(url);
    await page.waitForFunction(() => document.getElementById('bar').value > 0 && !document.getElementById('bar').hidden || document.querySelector('#digest code'));
    console.log('first rows', Date.now() - t);
    console.log(await digest(page), Date.now() - t, await page.textContent('#status'), await page.evaluate(() => document.documentElement.dataset.instructionSet));
    await shoot(page, 'start');
    console.log(faults, requests);
});
close();
