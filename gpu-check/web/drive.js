// What the test in tests/browser.rs has the page do: a person's steps, each with its result handed to the server.

import { tabulate } from "./lab.js";

const find = (id) => document.getElementById(id);
const post = (name, body) => fetch(`results/${name}`, { method: "POST", body });
const next = (event) => new Promise((resolve) => {
    document.addEventListener(event, ({ detail }) => resolve(detail), { once: true });
});

function type(text) {
    find("source").value = text;
    find("source").dispatchEvent(new Event("input"));
}

const canvas = () => {
    const { width, height } = find("here");
    return find("here").getContext("2d").getImageData(0, 0, width, height).data;
};

export async function drive(started) {
    try {
        const first = next("rendered");
        const lab = await started;
        await post("adapter", lab.name);
        await post("picture", await first);
        await post("shown", canvas());
        for (const kernel of lab.kernels) await post(kernel.module, await tabulate(lab, kernel));

        const good = find("source").value;
        const edited = next("rendered");
        type(good.replace("background.light * (real(1.0) - m)", "background.dark * (real(1.0) - m)"));
        await post("edited", await edited);
        const before = canvas();
        const refused = next("refused");
        type(good.replace("direction.y", "direktion.y"));
        await refused;
        await post("error", find("error").textContent);
        await post("kept", String(canvas().every((byte, i) => byte === before[i])));
        const healed = next("rendered");
        type(good);
        await post("healed", await healed);
        await post("done", find("error").textContent);
    } catch (error) {
        await post("failed", `${error.message}\n${error.stack}`);
    }
}
