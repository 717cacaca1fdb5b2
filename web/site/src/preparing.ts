// A worker that checks texts, reads scenes for the shaders, and renders the same pictures by Rust.
import { isFault, Renderer, type Fault, type TextNumber, type Truth } from './module';

/** What the page asks for. */
export type Request =
    | { kind: 'check'; text: TextNumber; content: string }
    | { kind: 'prepare'; config: string; scene: string }
    | { kind: 'aim'; config: string }
    | { kind: 'truth'; truth: Truth }
    | { kind: 'steps'; pixel: number };

/** A question with its number. The first message of the page has the module. */
export type Question = { module: WebAssembly.Module } | { question: number; request: Request };

/** The answer to a question: bytes and facts, or a fault. */
export interface Answer {
    question: number;
    /** The buffers of the shaders for `prepare`, the first of them for `aim`, and one list of numbers otherwise. */
    bytes: Uint8Array<ArrayBuffer>[];
    /** The facts for `prepare` and `aim`, and the faults of a text for `check`, as JSON. */
    facts: string;
    fault: Fault | null;
}

let module: WebAssembly.Module | null = null;
let renderer: Renderer | null = null;

function answer(loaded: Renderer, request: Request): Pick<Answer, 'bytes' | 'facts'> | Fault {
    switch (request.kind) {
        case 'check':
            loaded.write(request.text, request.content);
            return { bytes: [], facts: JSON.stringify(loaded.check(request.text)) };
        case 'prepare': {
            loaded.write(0, request.config);
            loaded.write(1, request.scene);
            const fault = loaded.prepare();
            return fault ?? read(loaded, [0, 1, 2, 3, 8]);
        }
        case 'aim': {
            loaded.write(0, request.config);
            const fault = loaded.aim();
            return fault ?? read(loaded, [0]);
        }
        case 'truth': {
            const colors = loaded.truth(request.truth);
            return isFault(colors) ? colors : { bytes: [colors], facts: '' };
        }
        case 'steps': {
            const steps = loaded.steps(request.pixel);
            return isFault(steps) ? steps : { bytes: [steps], facts: '' };
        }
    }
}

function read(loaded: Renderer, parts: number[]): Pick<Answer, 'bytes' | 'facts'> | Fault {
    const bytes: Uint8Array<ArrayBuffer>[] = [];
    for (const part of parts) {
        const buffer = loaded.packed(part);
        if (isFault(buffer)) {
            return buffer;
        }
        bytes.push(buffer);
    }
    const facts = loaded.packed(4);
    return isFault(facts) ? facts : { bytes, facts: new TextDecoder().decode(facts) };
}

async function respond(question: number, request: Request): Promise<void> {
    let result: Pick<Answer, 'bytes' | 'facts'> | Fault;
    try {
        renderer ??= module && (await Renderer.create(module));
        result = renderer ? answer(renderer, request) : { text: 2, line: 0, column: 0, length: 0, message: '' };
    } catch (error) {
        // The memory is exhausted. The next question begins with a new instance.
        renderer = null;
        result = { text: 2, line: 0, column: 0, length: 0, message: String(error) };
    }
    const { bytes, facts } = isFault(result) ? { bytes: [], facts: '' } : result;
    const fault = isFault(result) ? result : null;
    postMessage({ question, bytes, facts, fault } satisfies Answer, { transfer: bytes.map((one) => one.buffer) });
}

// The questions are answered in order, because one renderer answers them all.
let last = Promise.resolve();
addEventListener('message', ({ data }: MessageEvent<Question>) => {
    if ('module' in data) {
        module = data.module;
    } else {
        last = last.then(() => respond(data.question, data.request));
    }
});
