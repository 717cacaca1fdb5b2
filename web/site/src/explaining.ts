// A worker that explains pixels with a module of its own, which is loaded when it starts.

/** What the page asks for: both texts, a pixel, a sample, and the number of random vectors before the pixel's row. */
export interface Question {
    texts: [config: string, scene: string];
    numbers: [column: number, row: number, sample: number, vectors: number];
}

interface Exports {
    memory: WebAssembly.Memory;
    room(text: number, length: number): number;
    explain(column: number, row: number, sample: number, vectors: number): number;
    result(): number;
}

async function load(): Promise<WebAssembly.Module> {
    const response = await fetch('explain.wasm');
    if (!response.ok) {
        throw new Error(`${response.url}: ${response.status}`);
    }
    return WebAssembly.compile(await response.arrayBuffer());
}

const loading = load();

/** Returns the life of a pixel as JSON. Each question has an instance of its own, as one may exhaust its memory. */
async function answer({ texts, numbers }: Question): Promise<string> {
    const { exports } = await WebAssembly.instantiate(await loading) as unknown as { exports: Exports };
    texts.map((text) => new TextEncoder().encode(text)).forEach((bytes, text) => {
        const address = exports.room(text, bytes.length) >>> 0;
        new Uint8Array(exports.memory.buffer).set(bytes, address);
    });
    const length = exports.explain(...numbers) >>> 0;
    return new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.result() >>> 0, length));
}

addEventListener('message', ({ data }: MessageEvent<Question>) => {
    const failed = (error: unknown) => JSON.stringify({ message: String(error) });
    void answer(data).catch(failed).then((life) => postMessage(life));
});
