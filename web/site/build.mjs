// Bundles the page into a folder: node web/site/build.mjs FOLDER. The script web/build calls it.
import { cpSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const scenes = join(here, '../../scenes');
const out = process.argv[2];
if (!out) {
    console.error('usage: node web/site/build.mjs FOLDER');
    process.exit(2);
}

await build({
    entryPoints: [...['main', 'worker', 'preparing', 'explaining'].map((name) => join(here, `src/${name}.ts`))],
    outdir: out,
    bundle: true,
    splitting: true,
    loader: { '.wgsl': 'text' },
    minify: true,
    format: 'esm',
    target: 'es2022',
    legalComments: 'eof',
    logLevel: 'warning',
});
for (const name of ['index.html', '404.html', 'page.css', 'icon.svg']) {
    cpSync(join(here, name), join(out, name));
}
cpSync(join(here, '../../docs/files.md'), join(out, 'files.txt'));
// The examples are the folders of scenes/, and a list of their names.
const names = readdirSync(scenes).sort();
for (const name of names) {
    mkdirSync(join(out, 'scenes', name), { recursive: true });
    for (const file of ['config.txt', 'scene.txt']) {
        cpSync(join(scenes, name, file), join(out, 'scenes', name, file));
    }
}
writeFileSync(join(out, 'scenes/names.json'), JSON.stringify(names));
