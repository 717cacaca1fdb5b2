// Renders a picture with the module, in a worker.
import type { Fault } from './module';
import type { Texts } from './store';
import { say } from './words';
import type { Message, Task } from './worker';

/** What is told while a picture is rendered. */
export interface Watcher {
    /** The picture's size, and the step between shown pixels. */
    begin(width: number, height: number, step: number): void;
    /** The number of finished rows. */
    progress(done: number, height: number): void;
    /** Pixels of whole shown rows from the row `first` on. */
    show(pixels: ImageData, first: number): void;
    /** The file, its digest, and the numbers of random vectors before each row. */
    done(ppm: Uint8Array<ArrayBuffer>, digest: string, vectors: number[]): void;
    fault(fault: Fault): void;
    failed(text: string): void;
}

/** Starts to render, and returns the function that cancels it. */
export function render(module: WebAssembly.Module, texts: Texts, watcher: Watcher): () => void {
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
                watcher.done(data.ppm, data.digest, data.vectors);
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
}
