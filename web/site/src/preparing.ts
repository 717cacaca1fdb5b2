// A worker that checks texts, reads scenes for the shaders, and renders the same pictures by Rust.
import { Faulty, faultOf, Renderer, type Fault, type TextNumber, type Truth } from './module';

/** What the page asks for. */
export type Request =
    | { kind: 'check'; text: TextNumber; content: string }
    | { kind: 'prepare'; config: string; scene: string }
    | { kind: 'aim'; config: string }
    | { kind: 'truth'; number: Truth }
    | { kind: 'steps'; number: number };

/** A question. The first message of the page has the module. */
export type Question = { module: WebAssembly.Module } | { request: Request };

/** What answers a question without a fault. */
export interface Found {
    /** The buffers of the shaders for `prepare`, the first of them for `aim`, and one list of numbers otherwise. */
    bytes: Uint8Array<ArrayBuffer>[];
    /** The facts for `prepare` and `aim`, and the faults of a text for `check`, as JSON. */
    facts: string;
}

/** The answer to a question. */
export type Answer = Found | Fault;

let module: WebAssembly.Module | null = null;
let renderer: Renderer | null = null;

function answer(loaded: Renderer, request: Request): Found {
    const read = (...parts: number[]) => ({
        bytes: parts.map((part) => loaded.ask('packed', part)), facts: new TextDecoder().decode(loaded.ask('packed', 4)) });
    switch (request.kind) {
        case 'check':
            loaded.write(request.text, request.content);
            return { bytes: [], facts: JSON.stringify(loaded.check(request.text)) };
        case 'prepare':
            loaded.write(0, request.config);
            loaded.write(1, request.scene);
            loaded.ask('prepare');
            return read(0, 1, 2, 3, 8);
        case 'aim':
            loaded.write(0, request.config);
            loaded.ask('aim');
            return read(0);
        default:
            return { bytes: [loaded.ask(request.kind, request.number)], facts: '' };
    }
}

async function respond(request: Request): Promise<void> {
    try {
        renderer ??= await Renderer.create(module as WebAssembly.Module);
        const found = answer(renderer, request);
        postMessage(found, { transfer: found.bytes.map(({ buffer }) => buffer) });
    } catch (error) {
        if (!(error instanceof Faulty)) {
            // The memory is exhausted. The next question begins with a new instance.
            renderer = null;
        }
        postMessage(faultOf(error));
    }
}

// The questions are answered in order, because one renderer answers them all.
let last = Promise.resolve();
addEventListener('message', ({ data }: MessageEvent<Question>) => {
    if ('module' in data) {
        module = data.module;
    } else {
        last = last.then(() => respond(data.request));
    }
});
