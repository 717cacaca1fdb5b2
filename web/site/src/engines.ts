// The two engines that render a picture: the module in a worker, and the program render-lab behind the page.
import type { Fault } from './module';
import { ask } from './secret';
import type { Texts } from './store';
import { read, shown } from './ppm';
import { stepOf } from './step';
import { messageOf, say } from './words';
import type { Message, Task } from './worker';

/** What an engine tells while it renders. */
export interface Watcher {
    /** The picture's size, and the step between shown pixels. */
    begin(width: number, height: number, step: number): void;
    /** The number of finished rows. */
    progress(done: number, height: number): void;
    /** Pixels of whole shown rows from the row `first` on. */
    show(pixels: ImageData, first: number): void;
    done(ppm: Uint8Array<ArrayBuffer>, digest: string): void;
    fault(fault: Fault): void;
    failed(text: string): void;
}

/** Starts an engine, and returns the function that cancels it. */
export type Engine = (texts: Texts, watcher: Watcher) => () => void;

/** Returns the engine that renders with `module` in a worker. */
export function inWorker(module: WebAssembly.Module): Engine {
    return (texts, watcher) => {
        const worker = new Worker('worker.js', { type: 'module' });
        let [width, height] = [0, 0];
        worker.onmessage = ({ data }: MessageEvent<Message>) => {
            switch (data.kind) {
                case 'begin':
                    width = Math.ceil(data.width / data.step);
                    height = data.height;
                    watcher.begin(data.width, data.height, data.step);
                    break;
                case 'rows':
                    watcher.progress(data.done, height);
                    if (data.pixels.length > 0) {
                        watcher.show(new ImageData(data.pixels, width), data.first);
                    }
                    break;
                case 'done':
                    worker.terminate();
                    watcher.done(data.ppm, data.digest);
                    break;
                case 'fault':
                    worker.terminate();
                    watcher.fault(data.fault);
                    break;
                case 'failed':
                    worker.terminate();
                    watcher.failed(data.text);
            }
        };
        worker.onerror = ({ message }) => watcher.failed(message || say('noModule', 'worker.js'));
        worker.postMessage({ module, ...texts } satisfies Task);
        return () => worker.terminate();
    };
}

/** Time between two questions how far the picture is, in milliseconds. */
const PAUSE = 200;

/** The engine that renders with `render-lab view`. The picture is shown when it is complete. */
export const native: Engine = (texts, watcher) => {
    const ends = new AbortController();
    const { signal } = ends;
    const look = async () => {
        const response = await ask('view/progress', { signal });
        const [done, height] = (await response.text()).split(' ').map(Number);
        if (!signal.aborted && done !== undefined && height) {
            watcher.progress(done, height);
        }
    };
    // A question without an answer is not repeated at once: the next one comes after the pause.
    const asks = setInterval(() => look().catch(() => null), PAUSE);
    // The server cancels a picture only by its number, so a late request cannot cancel the next picture.
    const number = crypto.getRandomValues(new Uint32Array(1))[0] ?? 0;
    const run = async () => {
        const response = await ask(`view/render/${number}`, { method: 'POST', body: JSON.stringify(texts), signal });
        if (!response.ok) {
            watcher.failed(await response.text());
            return;
        }
        const ppm = new Uint8Array(await response.arrayBuffer());
        const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', ppm));
        const picture = read(ppm);
        if (!signal.aborted) {
            const step = stepOf(picture.width, picture.height);
            watcher.begin(picture.width, picture.height, step);
            watcher.show(shown(picture, step), 0);
            watcher.progress(picture.height, picture.height);
            watcher.done(ppm, Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join(''));
        }
    };
    run().catch((error: unknown) => signal.aborted || watcher.failed(messageOf(error))).finally(() => ends.abort());
    signal.addEventListener('abort', () => clearInterval(asks));
    return () => {
        ends.abort();
        void ask(`view/cancel/${number}`, { method: 'POST' }).catch(() => null);
    };
};
