// Asks a worker, and waits for its answers, which come in the order of the questions.
import { say } from './words';

/** A worker that answers each question of the kind `Q` by one answer. */
export class Asked<Q extends object, A> {
    readonly #worker: Worker;
    #waiting: { answer: (answer: A) => void; fail: (error: Error) => void }[] = [];
    /** Why the worker answers no question, such as a script that cannot be loaded. */
    #failure: Error | null = null;

    constructor(script: string, module?: WebAssembly.Module) {
        this.#worker = new Worker(script, { type: 'module' });
        this.#worker.onmessage = ({ data }: MessageEvent<A>) => this.#waiting.shift()?.answer(data);
        this.#worker.onerror = ({ message }) => this.#fail(new Error(message || say('noModule', script)));
        if (module) {
            this.#worker.postMessage({ module });
        }
    }

    #fail(failure: Error): void {
        this.#failure = failure;
        this.#waiting.forEach(({ fail }) => fail(failure));
        this.#waiting = [];
    }

    /** Ends the worker. Questions without an answer fail. */
    end(): void {
        this.#worker.terminate();
        this.#fail(new Error(say('cancelled')));
    }

    /** Returns the answer to `request`. Throws if the worker fails. */
    ask(request: Q): Promise<A> {
        return new Promise((answer, fail) => {
            if (this.#failure) {
                fail(this.#failure);
                return;
            }
            this.#waiting.push({ answer, fail });
            this.#worker.postMessage(request);
        });
    }
}
