// Asks a worker, and waits for its answers. Questions have numbers, because a later answer may be known first.
import { say } from './words';

/** A worker that answers each question of the kind `Q` by one answer. */
export class Asked<Q extends object, A extends { question: number }> {
    readonly #worker: Worker;
    readonly #waiting = new Map<number, { answer: (answer: A) => void; fail: (error: Error) => void }>();
    #questions = 0;
    /** Why the worker answers no question, such as a script that cannot be loaded. */
    #failure: Error | null = null;

    constructor(script: string, module?: WebAssembly.Module) {
        this.#worker = new Worker(script, { type: 'module' });
        this.#worker.onmessage = ({ data }: MessageEvent<A>) => {
            this.#waiting.get(data.question)?.answer(data);
            this.#waiting.delete(data.question);
        };
        this.#worker.onerror = ({ message }) => this.#fail(new Error(message || say('noModule', script)));
        if (module) {
            this.#worker.postMessage({ module });
        }
    }

    #fail(failure: Error): void {
        this.#failure = failure;
        this.#waiting.forEach(({ fail }) => fail(failure));
        this.#waiting.clear();
    }

    /** Ends the worker. Questions without an answer fail. */
    end(): void {
        this.#worker.terminate();
        this.#fail(new Error(say('cancelled')));
    }

    /** Returns the answer to `request`. Throws if the worker fails. */
    ask(request: Q): Promise<A> {
        const question = ++this.#questions;
        return new Promise((answer, fail) => {
            if (this.#failure) {
                fail(this.#failure);
                return;
            }
            this.#waiting.set(question, { answer, fail });
            this.#worker.postMessage({ question, ...request });
        });
    }
}
