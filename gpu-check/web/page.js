// The page: pictures, the editor, and the table of formulas.

import { compared, differing, openLab, render, tabulate } from "./lab.js";

const find = (id) => document.getElementById(id);
const show = (id, text) => { find(id).textContent = text; };
const byte = (channel, gamma) => Math.floor(255 * Math.min(Math.max(channel, 0), 1) ** (1 / gamma));

function draw(id, { width, height }, color) {
    const canvas = find(id);
    Object.assign(canvas, { width, height });
    const image = new ImageData(width, height);
    for (let i = 0; i < width * height; i++) image.data.set([...color(i), 255], 4 * i);
    canvas.getContext("2d").putImageData(image, 0, 0);
}

async function start() {
    const lab = await openLab();
    const { picture, native } = lab;
    show("adapter", `WebGPU: ${lab.name}. Native: ${picture.driver}.`);
    const pixel = (colors) => (i) => [0, 1, 2].map((c) => byte(colors[3 * i + c], picture.gamma));
    draw("native", picture, pixel(native));
    const parts = lab.parts.map((part) => ({ ...part }));
    const select = find("module");
    parts.forEach((part, i) => select.add(new Option(part.path, i)));
    const choose = () => { find("source").value = parts[select.value].source; };

    // Only the newest rendering is shown. One that ends after a newer one has begun is dropped.
    let newest = 0;
    async function refresh() {
        const own = ++newest;
        try {
            const begun = performance.now();
            const colors = await render(lab, parts);
            if (own !== newest) return;
            draw("here", picture, pixel(colors));
            const places = new Set(differing(colors, native).map((i) => Math.floor(i / 3)));
            draw("apart", picture, (i) => (places.has(i) ? [255, 255, 255] : [0, 0, 0]));
            show("here-note", `this browser, ${(performance.now() - begun).toFixed(0)} ms with compilation`);
            show("difference", `${places.size} of ${picture.pixels} pixels differ in a bit.`);
            show("error", "");
            document.dispatchEvent(new CustomEvent("rendered", { detail: colors }));
        } catch (error) {
            if (own !== newest) return;
            // The last good picture stays.
            show("error", error.message);
            document.dispatchEvent(new CustomEvent("refused", { detail: error.message }));
        }
    }

    select.addEventListener("change", choose);
    find("source").addEventListener("input", () => {
        parts[select.value].source = find("source").value;
        refresh();
    });
    find("check").addEventListener("click", async () => {
        const table = find("kernels");
        table.replaceChildren();
        const line = (...texts) => {
            const row = table.insertRow();
            texts.forEach((text) => { row.insertCell().textContent = text; });
        };
        line("formula", "cases", "as Rust's f32", "subnormal numbers as zeros (WGSL allows it)", "otherwise");
        const numbers = async (name) => new Float32Array(await (await fetch(`data/${name}`)).arrayBuffer());
        for (const kernel of lab.kernels) {
            const { module, outputs } = kernel;
            const [expected, flushed] = await Promise.all([numbers(`expected/${module}`), numbers(`flushed/${module}`)]);
            const counts = compared(await tabulate(lab, kernel), expected, flushed, outputs);
            const same = counts.rows - counts.flushed - counts.otherwise;
            line(module, counts.rows, same, counts.flushed, counts.otherwise);
        }
        document.dispatchEvent(new CustomEvent("checked", { detail: table.innerText }));
    });
    select.value = parts.findIndex((part) => part.path.endsWith("background.wgsl"));
    choose();
    await refresh();
    return lab;
}

const started = start();
started.catch((error) => show("error", error.message));
// A test drives the page as a user would.
if (location.search === "?drive") import("./drive.js").then(({ drive }) => drive(started));
