// Runs the probes that the server sends, and posts their results. The program `conformance` decides what they mean.

import { ShaderFault, compile, openDevice, run } from "./gpu.js";

const show = (text) => { document.getElementById("state").textContent = text; };
const post = (name, body) => fetch(`results/${name}`, { method: "POST", body });

async function runAll() {
    const probes = await (await fetch("data/probes")).json();
    const { device, name } = await openDevice();
    await post("adapter", `${name}\n${navigator.userAgent}`);
    for (const { name, text, cases, size } of probes) {
        show(`Running ${name}.`);
        const input = await (await fetch(`data/input/${name}`)).arrayBuffer();
        try {
            const pipeline = await compile(device, text, "probe", [false, true]);
            await post(`result/${name}`, await run(device, pipeline, [input, size], 1, cases));
        } catch (error) {
            if (!(error instanceof ShaderFault)) throw error;
            await post(`refused/${name}`, error.message);
        }
    }
    await post("done", "");
    show("Done; the program has the results.");
}

runAll().catch(async (error) => {
    show(error.message);
    await post("failed", error.message);
});
