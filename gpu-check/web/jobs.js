// Runs the shaders that the server lists as jobs, and posts the bytes of each result to the server.

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

// Jobs with the same shader and constants share a pipeline, whose compilation may take many seconds.
const pipelines = new Map();
async function pipeline(device, { wgsl, entry, written, constants }) {
    const key = JSON.stringify([wgsl, constants]);
    if (!pipelines.has(key)) {
        const code = await (await fetched(wgsl)).text();
        pipelines.set(key, await compile(device, code, entry, written, constants));
    }
    return pipelines.get(key);
}

async function work() {
    const { device, name } = await openDevice();
    await post("adapter", name);
    for (const job of await (await fetched("jobs")).json()) {
        show(job.name);
        const begun = performance.now();
        const compiled = await pipeline(device, job);
        const contents = await Promise.all(job.contents.map(content));
        const bytes = await run(device, compiled, contents, job.output, job.invocations);
        const time = performance.now() - begun;
        await post(job.name, bytes);
        await post(`${job.name}/time`, time.toFixed(0));
    }
    show("Done.");
    await post("done", "");
}

work().catch((error) => post("failed", `${error.message}\n${error.stack}`));
