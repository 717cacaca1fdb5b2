// Checks texts in a worker, so that the page answers while a long text is parsed.
import { Renderer, type Fault, type TextNumber } from './module';

/** What the page sends: first the module, then texts with the numbers of their questions. */
export type Question = { module: WebAssembly.Module } | { question: number; text: TextNumber; content: string };

/** What the worker sends for each text. */
export interface Verdict {
    question: number;
    faults: Fault[];
}

let module: WebAssembly.Module | null = null;
let renderer: Renderer | null = null;

async function faultsOf(text: TextNumber, content: string): Promise<Fault[]> {
    try {
        renderer ??= module && (await Renderer.create(module));
        renderer?.write(text, content);
        return renderer?.check(text) ?? [];
    } catch (error) {
        // The memory is exhausted. The next check begins with a new instance.
        renderer = null;
        return [{ text, line: 0, column: 0, length: 0, message: String(error) }];
    }
}

addEventListener('message', ({ data }: MessageEvent<Question>) => {
    if ('module' in data) {
        module = data.module;
    } else {
        const { question, text, content } = data;
        void faultsOf(text, content).then((faults) => postMessage({ question, faults } satisfies Verdict));
    }
});
