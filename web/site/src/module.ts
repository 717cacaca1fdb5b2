// Loads the WebAssembly module of web/wasm, and calls its functions with texts instead of addresses.
import type { Module } from './gpu/compose';
import { messageOf, ofLanguage, say, type Key } from './words';

/** The number of a text: 0 is the configuration, 1 the scene. */
export type TextNumber = 0 | 1;

/** An error of the renderer with its place. */
export interface Fault {
    /** 0 is the configuration, 1 the scene, 2 neither of them. */
    text: number;
    /** Counted from 1; 0 if the fault is not about a line. */
    line: number;
    /** Counted from 1, in units of UTF-16. */
    column: number;
    /** Length of the wrong word in units of UTF-16; 0 if a word is missing. */
    length: number;
    /** The message of render-aos, without `Error: `. */
    message: string;
    /** What is wrong and what to write instead, in English and in Spanish. */
    hints?: [english: string, spanish: string];
}

/** Returns the message of a fault and what to do, in the page's language. */
export function textOf({ message, hints = ['', ''] }: Fault): string {
    // The specification prescribes the messages of the programs in English.
    return [ofLanguage(['', 'Los programas dicen: ']) + message, ofLanguage(hints)].filter(Boolean).join('\n');
}

/** Returns why there is no picture, in the page's language. */
export const causeOf = ({ message, hints }: Fault): string => ofLanguage([message, hints?.[1] || message]);

/** Returns the fault that an exception means, which is about neither text. */
export const faultOf = (error: unknown): Fault =>
    (error instanceof Faulty ? error.fault : { text: 2, line: 0, column: 0, length: 0, message: messageOf(error) });

/** A fault as an exception. */
export class Faulty extends Error {
    constructor(readonly fault: Fault) {
        super(fault.message);
    }

    /** Returns the message for a view: after `key` for a fault of the texts, and otherwise as one of the renderer. */
    say(key: Key): string {
        return say(this.fault.text < 2 ? key : 'failed', causeOf(this.fault));
    }
}

/** Largest number of faults of a text that the module returns. */
export const MOST_FAULTS = 20;

/** One row of the table that `render-lab help config` or `help scene` prints. */
export interface Row {
    tag: string;
    values: string;
    default: string;
    meaning: string;
    spanishValues: string;
}

/** What a picture tells: its size, and each finished row with the number of random vectors up to its end, or NaN. */
export interface Progress {
    begin(width: number, height: number): void;
    row(row: number, pixels: Uint8ClampedArray, vectors: number): void;
}

/** Functions that return 0 for a result and 1 for a fault. A number that they do not have is 0. */
type Asked = 'render' | 'prepare' | 'aim' | 'packed' | 'truth' | 'steps';

interface Exports extends Record<Asked, (number: number) => number> {
    memory: WebAssembly.Memory;
    room(text: number, length: number): number;
    check(text: number): number;
    fault_at(index: number): void;
    digest(): void;
    table(text: number): void;
    step_names(): void;
    wgsl(): void;
    result(): number;
    result_length(): number;
    fault(): void;
}

/** Linear colours by the exact renderer (0) or by the twin of the shaders (1), or what the exact rays hit (2). */
export type Truth = 0 | 1 | 2;

/** Whether a result is a fault. */
export const isFault = (result: object): result is Fault => 'message' in result;

/** A module with one function that uses a 128-bit lane. It is valid only where such lanes are known. */
const LANES = new Uint8Array([
    0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/** The name of the instruction set that the module for this browser uses. */
export const instructionSet = WebAssembly.validate(LANES) ? 'simd128' : 'portable';

/** Loads the module that this browser can run. */
export async function compile(): Promise<WebAssembly.Module> {
    const response = await fetch(instructionSet === 'simd128' ? 'wasm-simd128.wasm' : 'wasm.wasm');
    if (!response.ok) {
        throw new Error(`${response.url}: ${response.status}`);
    }
    // A server that does not know the content type of WebAssembly sends another one, which the browser would refuse.
    const isKnown = response.headers.get('Content-Type') === 'application/wasm';
    return isKnown ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** An instance of the module. After an exception of one of its functions it must not be used any more. */
export class Renderer {
    readonly #exports: Exports;

    private constructor(exports: Exports) {
        this.#exports = exports;
    }

    static async create(module: WebAssembly.Module, progress?: Progress): Promise<Renderer> {
        let exports: Exports | undefined;
        let width = 0;
        const page = {
            begin(pictureWidth: number, height: number) {
                width = pictureWidth;
                progress?.begin(width, height);
            },
            row(row: number, address: number, vectors: number) {
                if (exports && progress) {
                    progress.row(row, new Uint8ClampedArray(exports.memory.buffer, address >>> 0, 4 * width), vectors);
                }
            },
        };
        const instance = await WebAssembly.instantiate(module, { page });
        exports = instance.exports as unknown as Exports;
        return new Renderer(exports);
    }

    /** Gives a text to the module. */
    write(text: TextNumber, content: string): void {
        const bytes = new TextEncoder().encode(content);
        const address = this.#exports.room(text, bytes.length) >>> 0;
        new Uint8Array(this.#exports.memory.buffer).set(bytes, address);
    }

    /** Returns the faults of a text that was written before, at most {@link MOST_FAULTS}. */
    check(text: TextNumber): Fault[] {
        return Array.from({ length: this.#exports.check(text) }, (_, index) => {
            this.#exports.fault_at(index);
            return this.#fault();
        });
    }

    /**
     * Calls a function, and returns its result. Throws {@link Faulty} for its fault. The result is a PPM file for
     * 'render', nothing for 'prepare' and 'aim', a buffer for the shaders (0 to 3, and 8 for the hierarchy) or the facts
     * (4) for 'packed', the f64 of a {@link Truth}, or the f32 of a pixel's steps.
     */
    ask(name: Asked, number = 0): Uint8Array<ArrayBuffer> {
        if (this.#exports[name](number) !== 0) {
            throw new Faulty(this.#fault());
        }
        return this.#result().slice();
    }

    /** Returns the SHA-256 digest of the last result, which it replaces. */
    digest(): string {
        this.#exports.digest();
        return this.#text();
    }

    /** Returns the rows of the table that describes the lines of a text. */
    table(text: TextNumber): Row[] {
        this.#exports.table(text);
        return this.#text().split('\n').map((line) => {
            const [tag = '', values = '', start = '', meaning = '', spanishValues = ''] = line.split('\t');
            return { tag, values, default: start, meaning, spanishValues };
        });
    }

    /** Returns the names of a step's numbers. */
    stepNames(): string[] {
        this.#exports.step_names();
        return this.#text().split('\n');
    }

    /** Returns the WGSL modules. */
    wgsl(): Module[] {
        this.#exports.wgsl();
        return JSON.parse(this.#text()) as Module[];
    }

    #result(): Uint8Array<ArrayBuffer> {
        const { memory, result, result_length } = this.#exports;
        return new Uint8Array(memory.buffer as ArrayBuffer, result() >>> 0, result_length() >>> 0);
    }

    #text(): string {
        return new TextDecoder().decode(this.#result());
    }

    #fault(): Fault {
        const message = this.#text();
        this.#exports.fault();
        return { message, ...(JSON.parse(this.#text()) as Omit<Fault, 'message'>) };
    }
}
