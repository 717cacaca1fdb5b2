// Renders with the WebAssembly module as render-aos does with the processor.
//
//   node tests/platforms/render.mjs MODULE.wasm CONFIG SCENE OUT.ppm
//
// RENDER_LAYOUT=soa takes structures of arrays, RENDER_INSTRUCTION_SET=portable does without 128-bit lanes.
import { readFileSync, writeFileSync } from 'node:fs';

const [module, config, scene, out] = process.argv.slice(2);
if (!out) {
    console.error('usage: node render.mjs MODULE.wasm CONFIG SCENE OUT.ppm');
    process.exit(2);
}
// The module tells about every row, for a caller that shows them.
const page = { begin() {}, row() {} };
const { instance } = await WebAssembly.instantiate(readFileSync(module), { page });
const { memory, room, render, result, result_length } = instance.exports;
[config, scene].forEach((path, text) => {
    const bytes = readFileSync(path);
    // Making room may move the memory, so its buffer is asked for afterwards.
    const address = room(text, bytes.length);
    new Uint8Array(memory.buffer).set(bytes, address);
});
const layout = process.env.RENDER_LAYOUT === 'soa' ? 1 : 0;
const status = render(layout, 0, process.env.RENDER_INSTRUCTION_SET === 'portable' ? 1 : 0);
const bytes = Buffer.from(memory.buffer, result(), result_length());
if (status === 0) {
    writeFileSync(out, bytes);
} else {
    console.error(`Error: ${bytes}`);
    process.exit(1);
}
