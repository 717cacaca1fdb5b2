// Asks a worker to read scenes for the shaders, and for the same pictures by Rust.
import type { Fault } from './module';
import type { Answer, Question, Request } from './preparing';
import type { Texts } from './store';

/** A vector: x, y and z. */
export type Vector = [number, number, number];

/** An object of the scene, for a plan of it. */
export type ShapeOf = [kind: 'sphere' | 'cylinder', center: Vector, radius: number, halfAxis: Vector];

/** What the page knows about a prepared scene besides its buffers. */
export interface Facts {
    width: number;
    height: number;
    gamma: number;
    depth: number;
    objects: number;
    position: Vector;
    target: Vector;
    north: Vector;
    constants: [name: string, value: number][];
    shapes: ShapeOf[];
}

/** A scene for the shaders: its facts, and the buffers with the bindings 0 to 3. */
export interface Prepared {
    facts: Facts;
    buffers: Uint8Array<ArrayBuffer>[];
}

/** A fault of the texts, as an exception. */
export class Faulty extends Error {
    constructor(readonly fault: Fault) {
        super(fault.message);
    }
}

/** A worker with one scene. */
export class Preparer {
    readonly #worker = new Worker('preparing.js', { type: 'module' });
    readonly #waiting = new Map<number, (answer: Answer) => void>();
    #questions = 0;

    constructor(module: WebAssembly.Module) {
        this.#worker.onmessage = ({ data }: MessageEvent<Answer>) => {
            this.#waiting.get(data.question)?.(data);
            this.#waiting.delete(data.question);
        };
        this.#worker.onerror = ({ message }) => {
            const fault = { text: 2, line: 0, column: 0, length: 0, message };
            this.#waiting.forEach((answer, question) => answer({ question, bytes: [], facts: '', fault }));
            this.#waiting.clear();
        };
        this.#worker.postMessage({ module } satisfies Question);
    }

    /** Reads both texts. Throws {@link Faulty} if one of them is wrong. */
    async prepare({ config, scene }: Texts): Promise<Prepared> {
        return this.#prepared(await this.#ask({ kind: 'prepare', config, scene }));
    }

    /** Reads the configuration again for the scene of the last {@link prepare}. The result has one buffer. */
    async aim(config: string): Promise<Prepared> {
        return this.#prepared(await this.#ask({ kind: 'aim', config }));
    }

    /** Returns the linear colours in deterministic mode: three numbers for each pixel. */
    async truth(isSingle: boolean): Promise<Float64Array<ArrayBuffer>> {
        const { bytes } = await this.#ask({ kind: 'truth', isSingle });
        return new Float64Array(bytes[0]?.buffer ?? new ArrayBuffer(0));
    }

    /** Returns the steps of a pixel's path by Rust in f32. */
    async steps(pixel: number): Promise<Float32Array<ArrayBuffer>> {
        const { bytes } = await this.#ask({ kind: 'steps', pixel });
        return new Float32Array(bytes[0]?.buffer ?? new ArrayBuffer(0));
    }

    /** Ends the worker. */
    end(): void {
        this.#worker.terminate();
    }

    #prepared({ bytes, facts }: Answer): Prepared {
        return { buffers: bytes, facts: JSON.parse(facts) as Facts };
    }

    async #ask(request: Request): Promise<Answer> {
        const question = ++this.#questions;
        const answer = await new Promise<Answer>((resolve) => {
            this.#waiting.set(question, resolve);
            this.#worker.postMessage({ question, request } satisfies Question);
        });
        if (answer.fault) {
            throw new Faulty(answer.fault);
        }
        return answer;
    }
}
