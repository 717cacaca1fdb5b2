// The lab without its page: fetches modules, pictures and kernels from the server, and runs them.

import { compile, openDevice, run, ShaderFault } from "./gpu.js";

const bytes = async (name) => (await fetched(name)).arrayBuffer();
const json = async (name) => (await fetched(name)).json();

async function fetched(name) {
    const response = await fetch(`data/${name}`);
    if (!response.ok) throw new Error(`data/${name}: ${response.status}`);
    return response;
}

export async function openLab() {
    const { device, name } = await openDevice();
    const [picture, parts, kernels] = await Promise.all([json("picture"), json("parts"), json("kernels")]);
    const names = ["head", "spheres", "cylinders", "materials", "native"];
    const [head, spheres, cylinders, materials, native] = await Promise.all(names.map(bytes));
    const inputs = [head, spheres, cylinders, materials];
    return { device, name, picture, parts, kernels, inputs, native: new Float32Array(native) };
}

// Renders with `parts`, each of which is a file's path and text. An error message gives the file in which the fault is.
export async function render(lab, parts) {
    const { pixels, depth, constants } = lab.picture;
    const written = [false, false, false, false, true, true, true];
    const code = parts.map((part) => ended(part.source)).join("");
    const pipeline = await compile(lab.device, code, "image", written, constants).catch((error) => {
        throw error instanceof ShaderFault ? new Error(located(error, parts)) : error;
    });
    // Sizes as in renderer.rs: the materials that attenuate each path, the colours, and the states of paths between
    // runs.
    const contents = [...lab.inputs, pixels * depth * 4, pixels * 12, pixels * 32];
    return new Float32Array(await run(lab.device, pipeline, contents, 5, pixels));
}

// The results of the kernel for all its cases.
export async function tabulate(lab, { module, entry, inputs, outputs }) {
    const [code, cases] = [await (await fetched(`wgsl/${module}`)).text(), await bytes(`cases/${module}`)];
    const pipeline = await compile(lab.device, code, entry, [false, true], {});
    const rows = cases.byteLength / 4 / inputs;
    return new Float32Array(await run(lab.device, pipeline, [cases, rows * outputs * 4], 1, rows));
}

// Indices at which the bits of two rows of f32 differ. Two NaN do not differ.
export function differing(one, other) {
    const [a, b] = [one, other].map((row) => new Uint32Array(row.buffer, row.byteOffset, row.length));
    const places = [];
    for (let i = 0; i < a.length; i++) {
        if (a[i] !== b[i] && !(Number.isNaN(one[i]) && Number.isNaN(other[i]))) places.push(i);
    }
    return places;
}

// Counts a kernel's rows of `outputs` numbers. `flushed` counts the rows that differ from Rust's f32, but are as in f32
// with subnormal numbers flushed to zero, which WGSL allows. `otherwise` counts all other rows that differ.
export function compared(results, expected, flushed, outputs) {
    const counts = { rows: results.length / outputs, flushed: 0, otherwise: 0 };
    const rows = new Set(differing(results, expected).map((i) => Math.floor(i / outputs)));
    for (const row of rows) {
        const [here, there] = [results, flushed].map((numbers) => numbers.subarray(row * outputs, (row + 1) * outputs));
        counts[differing(here, there).length === 0 ? "flushed" : "otherwise"] += 1;
    }
    return counts;
}

const ended = (text) => (text.endsWith("\n") ? text : `${text}\n`);

// The error message: file, line, column and message, and the line with a caret under the fault.
function located({ message, line, column }, parts) {
    let first = 1;
    for (const { path, source } of parts) {
        const lines = ended(source).split("\n").slice(0, -1);
        if (line >= first && line < first + lines.length) {
            const own = line - first + 1;
            const margin = `${own} | `;
            const caret = " ".repeat(margin.length + Math.max(column - 1, 0));
            return `${path}:${own}:${column}: ${message}\n${margin}${lines[own - 1]}\n${caret}^`;
        }
        first += lines.length;
    }
    return message;
}
