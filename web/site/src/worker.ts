// Renders one picture in a worker, and sends rows while it renders. The page ends a picture by ending the worker.
import { Faulty, Renderer, type Fault } from './module';
import { stepOf } from './step';

/** What the page sends, once. */
export interface Task {
    module: WebAssembly.Module;
    config: string;
    scene: string;
}

/** What the worker sends. The pixels have four bytes each. */
export type Message =
    | { kind: 'begin'; width: number; height: number; step: number }
    | { kind: 'rows'; done: number; first: number; pixels: Uint8ClampedArray<ArrayBuffer> }
    | { kind: 'done'; ppm: Uint8Array<ArrayBuffer>; digest: string; vectors: number[] }
    | { kind: 'fault'; fault: Fault }
    | { kind: 'failed'; text: string };

/** Shortest time between two messages with rows, in milliseconds. */
const PAUSE = 40;

const send = (message: Message, transferred: Transferable[] = []) => postMessage(message, { transfer: transferred });

/** Collects finished rows, and sends several of them in one message. */
class Rows {
    /** The numbers of random vectors before each row. */
    readonly vectors = [0];
    #width = 0;
    #height = 0;
    #step = 1;
    #pixels = new Uint8ClampedArray(0);
    /** The shown rows that have been sent, and those that are finished. */
    #sent = 0;
    #finished = 0;
    #last = 0;

    begin(width: number, height: number): void {
        this.#step = stepOf(width, height);
        this.#width = Math.ceil(width / this.#step);
        this.#height = height;
        this.#pixels = new Uint8ClampedArray(4 * this.#width * Math.ceil(height / this.#step));
        send({ kind: 'begin', width, height, step: this.#step });
    }

    row(row: number, pixels: Uint8ClampedArray, vectors: number): void {
        this.vectors.push(vectors);
        if (row % this.#step === 0) {
            this.#add(pixels);
        }
        if (performance.now() - this.#last >= PAUSE || row + 1 === this.#height) {
            this.#last = performance.now();
            this.#send(row + 1);
        }
    }

    #add(row: Uint8ClampedArray): void {
        const start = 4 * this.#width * this.#finished;
        if (this.#step === 1) {
            this.#pixels.set(row, start);
        } else {
            for (let column = 0; column < this.#width; column++) {
                const from = 4 * column * this.#step;
                this.#pixels.set(row.subarray(from, from + 4), start + 4 * column);
            }
        }
        this.#finished += 1;
    }

    #send(done: number): void {
        const pixels = this.#pixels.slice(4 * this.#width * this.#sent, 4 * this.#width * this.#finished);
        send({ kind: 'rows', done, first: this.#sent, pixels }, [pixels.buffer]);
        this.#sent = this.#finished;
    }
}

async function run({ module, config, scene }: Task): Promise<void> {
    const rows = new Rows();
    const renderer = await Renderer.create(module, rows);
    renderer.write(0, config);
    renderer.write(1, scene);
    const ppm = renderer.ask('render');
    send({ kind: 'done', ppm, digest: renderer.digest(), vectors: rows.vectors }, [ppm.buffer]);
}

addEventListener('message', (event: MessageEvent<Task>) => {
    // A module whose memory is exhausted ends with an exception.
    run(event.data).catch((error: unknown) =>
        send(error instanceof Faulty ? { kind: 'fault', fault: error.fault } : { kind: 'failed', text: String(error) }));
});
