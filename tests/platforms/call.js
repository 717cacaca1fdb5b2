// Calls the WebAssembly module. `render.mjs` loads this file in Node.js, and `page.html` loads it in a browser.

// Returns the PPM file as bytes. Throws an error with the renderer's message if there is no picture.
globalThis.renderPicture = (module, config, scene, isSoa, isPortable) => {
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
