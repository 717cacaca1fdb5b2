// Runs the probes that the server sends, and posts their results. The program `conformance` decides what they mean.

import { ShaderFault, compile, openDevice, run } from "./gpu.js";

const show = (text) => { document.getElementById("state").textContent = text; };
const post = (name, body) => fetch(`results/${name}`, { method: "POST", body });

async function runAll() {
    const probes = await (await fetch("data/probes")).json();
    let { device, name: adapter } = await openDevice();
    await post("adapter", `${adapter}\n${navigator.userAgent}`);
    for (const { name, text, cases, size } of probes) {
        show(`Running ${name}.`);
        const input = await (await fetch(`data/input/${name}`)).arrayBuffer();
        try {
            device ??= (await openDevice()).device;
            const pipeline = await compile(device, text, "probe", [false, true]);
            await post(`result/${name}`, await run(device, pipeline, [input, size], 1, cases));
        } catch (error) {
            const isRefused = error instanceof ShaderFault;
            await post(`${isRefused ? "refused" : "ended"}/${name}`, error.message);
            // Another error means that the device may be lost, so the next probe opens a new one.
            if (!isRefused) device = null;
        }
    }
    await post("done", "");
    show("Done; the program has the results.");
}

runAll().catch(async (error) => {
    show(error.message);
    await post("failed", error.message);
});
