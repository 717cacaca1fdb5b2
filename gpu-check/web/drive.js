// Drives the page for the test in tests/browser.rs: does what a user would do, and posts each result to the server.

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

// The width that the page needs and the width of the window, on a phone, with pictures that are wider than the window.
async function onPhone() {
    const frame = document.createElement("iframe");
    frame.style = "width: 390px; height: 844px; border: 0";
    frame.src = "/";
    document.body.append(frame);
    await new Promise((resolve) => { frame.onload = resolve; });
    const inside = frame.contentDocument;
    while (!inside.getElementById("difference").textContent) await new Promise((resolve) => { setTimeout(resolve, 50); });
    ["here", "native", "apart"].forEach((id) => { inside.getElementById(id).width = 480; });
    const { scrollWidth, clientWidth } = inside.documentElement;
    frame.remove();
    return [scrollWidth, clientWidth];
}

// The width of the page's icon; 0 if there is none.
async function iconWidth() {
    const icon = new Image();
    icon.src = document.querySelector("link[rel=icon]").href;
    await icon.decode().catch(() => {});
    return icon.naturalWidth;
}

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
        const checked = next("checked");
        find("check").click();
        await checked;
        const rows = [...find("kernels").rows].slice(1).map((row) => [...row.cells].map((cell) => cell.textContent));
        await post("table", JSON.stringify(rows));
        await post("width", (await onPhone()).join(" "));
        await post("icon", String(await iconWidth()));
        await post("done", find("error").textContent);
    } catch (error) {
        await post("failed", `${error.message}\n${error.stack}`);
    }
}
