// Renders with the WebAssembly module as render-aos does with the processor.
//
//   node tests/platforms/render.mjs MODULE.wasm aos|soa CONFIG SCENE OUT.ppm
//
// RENDER_INSTRUCTION_SET=portable does without 128-bit lanes.
import { readFileSync, writeFileSync } from 'node:fs';

// Returns the PPM file as bytes. Throws an error with the renderer's message if there is no picture.
const renderPicture = (module, config, scene, isSoa, isPortable) => {
    // The module calls these functions for every row, for a page that shows the rows.
    const page = { begin() {}, row() {} };
    const { memory, room, render, result, result_length } = new WebAssembly.Instance(module, { page }).exports;
    [config, scene].forEach((bytes, text) => {
        // Making room may move the memory, so its buffer is asked for afterwards.
        const address = room(text, bytes.length);
        new Uint8Array(memory.buffer).set(bytes, address);
    });
    const status = render(isSoa ? 1 : 0, 0, isPortable ? 1 : 0);
    const bytes = new Uint8Array(memory.buffer, result(), result_length());
    if (status !== 0) throw new Error(new TextDecoder().decode(bytes));
    return bytes;
};

const [path, layout, config, scene, out] = process.argv.slice(2);
if (!out) {
    console.error('usage: node render.mjs MODULE.wasm aos|soa CONFIG SCENE OUT.ppm');
    process.exit(2);
}
const module = new WebAssembly.Module(readFileSync(path));
const { RENDER_INSTRUCTION_SET } = process.env;
try {
    const texts = [config, scene].map((file) => readFileSync(file));
    writeFileSync(out, renderPicture(module, ...texts, layout === 'soa', RENDER_INSTRUCTION_SET === 'portable'));
} catch (error) {
    console.error(`Error: ${error.message}`);
    process.exit(1);
}
