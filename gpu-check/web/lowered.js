// Runs the shaders that the server lists as jobs, and posts the bytes of each result: for tests/browser_lowered.rs.

import { compile, openDevice, run } from "./gpu.js";

const post = (name, body) => fetch(`results/${name}`, { method: "POST", body });
const show = (text) => { document.getElementById("state").textContent = text; };

async function fetched(name) {
    const response = await fetch(`data/${name}`);
    if (!response.ok) throw new Error(`data/${name}: ${response.status}`);
    return response;
}

// The buffers that several jobs read are fetched once.
const buffers = new Map();
async function content(item) {
    if (typeof item === "number") return item;
    if (!buffers.has(item)) buffers.set(item, await (await fetched(item)).arrayBuffer());
    return buffers.get(item);
}

async function work() {
    const { device, name } = await openDevice();
    await post("adapter", name);
    for (const job of await (await fetched("jobs")).json()) {
        show(job.name);
        const begun = performance.now();
        const code = await (await fetched(job.wgsl)).text();
        const pipeline = await compile(device, code, job.entry, job.written, job.constants);
        const contents = await Promise.all(job.contents.map(content));
        const bytes = await run(device, pipeline, contents, job.output, job.invocations);
        const time = performance.now() - begun;
        await post(job.name, bytes);
        await post(`${job.name}/time`, time.toFixed(0));
    }
    show("Done.");
    await post("done", "");
}

work().catch((error) => post("failed", `${error.message}\n${error.stack}`));
