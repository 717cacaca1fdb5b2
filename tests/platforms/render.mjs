// Renders with the WebAssembly module as render-aos does with the processor.
//
//   node tests/platforms/render.mjs MODULE.wasm CONFIG SCENE OUT.ppm
//
// RENDER_LAYOUT=soa takes structures of arrays, RENDER_INSTRUCTION_SET=portable does without 128-bit lanes.
import { readFileSync, writeFileSync } from 'node:fs';

import './call.js';

const [path, config, scene, out] = process.argv.slice(2);
if (!out) {
    console.error('usage: node render.mjs MODULE.wasm CONFIG SCENE OUT.ppm');
    process.exit(2);
}
const module = new WebAssembly.Module(readFileSync(path));
const { RENDER_LAYOUT, RENDER_INSTRUCTION_SET } = process.env;
try {
    const texts = [config, scene].map((file) => readFileSync(file));
    writeFileSync(out, renderPicture(module, ...texts, RENDER_LAYOUT === 'soa', RENDER_INSTRUCTION_SET === 'portable'));
} catch (error) {
    console.error(`Error: ${error.message}`);
    process.exit(1);
}
