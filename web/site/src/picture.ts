// The picture with its bar, its digest and the buttons that save it.
import { save } from './files';
import type { Fault } from './module';
import { ExactView } from './exact-view';
import type { Explained } from './explain';
import { png, read, shown, type Rgb } from './ppm';
import { erase, paint, put, resize } from './shown';
import { stepOf } from './step';
import { isSame, type Texts } from './store';
import { Viewer } from './viewer';
import { element, say, write } from './words';
import type { Message, Task } from './worker';

/** The part of the page that shows the picture. */
export class Picture {
    readonly #canvas = element<HTMLCanvasElement>('canvas');
    readonly #bar = element<HTMLProgressElement>('bar');
    readonly #status = element('status');
    readonly #digest = element('digest');
    readonly #cancel = element<HTMLButtonElement>('cancel');
    readonly #saves = [element<HTMLButtonElement>('save-ppm'), element<HTMLButtonElement>('save-png')];
    readonly #viewer = new Viewer(element('exact-stage'), {
        told: (column, row) => this.#view.told(column, row),
        clicked: (column, row) => {
            const step = Number(this.#canvas.dataset.step ?? 1);
            const place = [Math.ceil(column * step), Math.ceil(row * step)] as const;
            this.choose(...place);
            void this.#view.clicked(...place);
        },
    });
    readonly #view: ExactView;
    #worker: Worker | null = null;
    #state = () => '';
    /** Whether a message of the page stays until the user acts, so that a running picture does not replace it. */
    #isWarned = false;
    /** Whether the canvas has the picture of the last texts, or a part of it. */
    #isBegun = true;
    #ppm: Uint8Array<ArrayBuffer> | null = null;
    #pixels: Rgb | null = null;
    #vectors: number[] = [];
    /** The pixel of the picture that was clicked last. */
    #place: [column: number, row: number] | null = null;
    /** The texts of the picture, also if it is not finished. */
    #texts: Texts | null = null;

    constructor(
        private readonly onFault: (fault: Fault) => void,
        private readonly onDone: () => void,
        name: () => string,
        module: () => WebAssembly.Module,
        goTo: (line: number) => void,
    ) {
        this.#view = new ExactView(module, {
            texts: () => (this.#ppm ? this.#texts : null),
            paint: (image, step) => this.#paint(image, step),
            goTo,
            say: (text) => this.note(text),
        });
        this.#cancel.addEventListener('click', () => this.cancel());
        const ppm = () => new Blob([this.#ppm ?? ''], { type: 'image/x-portable-pixmap' });
        this.#saves[0]?.addEventListener('click', () => save(`${name()}.ppm`, ppm()));
        this.#saves[1]?.addEventListener('click', async () => {
            if (this.#ppm) {
                save(`${name()}.png`, new Blob([await png(this.#ppm)], { type: 'image/png' }));
            }
        });
    }

    /** Shows the state of the picture below it. */
    say(text: () => string): void {
        this.#state = text;
        this.note(null);
    }

    /** Shows the state of a running or finished picture, unless a message stays. */
    #tell(text: () => string): void {
        this.#isWarned ? (this.#state = text) : this.say(text);
    }

    /**
     * Shows a message of the page instead of the state, until the state changes; null shows the state again. If `stays`
     * holds, a picture that goes on or is finished does not replace the message.
     */
    note(text: (() => string) | null, stays = false): void {
        this.#isWarned = stays;
        write(this.#status, text ?? this.#state);
    }

    /** The pixels of the picture, if it is finished. */
    get pixels(): Rgb | null {
        return this.#pixels ??= this.#ppm && read(this.#ppm);
    }

    /** What explains a pixel of the picture, if it is finished: texts, pixels, and the pixel that was clicked last. */
    get explained(): Explained | null {
        const [texts, pixels] = [this.#texts, this.pixels];
        return texts && pixels && { texts, pixels, vectors: this.#vectors, place: this.#place };
    }

    /** Whether there is no picture, not even an unfinished one. */
    get isNone(): boolean {
        return this.#texts === null;
    }

    /** Chooses a pixel to explain. */
    choose(column: number, row: number): void {
        this.#place = [column, row];
        const step = Number(this.#canvas.dataset.step ?? 1);
        this.#viewer.choose([Math.floor(column / step), Math.floor(row / step)]);
    }

    /** Whether the picture belongs to these texts. Without a picture this holds. */
    isOf(texts: Texts): boolean {
        return this.#texts === null || isSame(this.#texts, texts);
    }

    /** Shows a view of the picture, or the picture itself again. */
    #paint(image: ImageData | null, step: number): void {
        const pixels = this.pixels;
        const own = pixels && stepOf(pixels.width, pixels.height);
        const shownNow = image ?? (pixels && own && shown(pixels, own));
        if (shownNow) {
            this.#canvas.dataset.step = String(image ? step : own);
            paint(this.#canvas, shownNow);
        }
    }

    /** Removes the picture, because another scene is loaded. */
    clear(): void {
        this.cancel();
        this.#forget(null);
        this.say(() => '');
        this.#viewer.fit();
        erase(this.#canvas);
    }

    /** Forgets the finished picture, because one of other texts follows. */
    #forget(texts: Texts | null): void {
        this.#texts = texts;
        this.#ppm = this.#pixels = null;
        this.#place = null;
        this.#viewer.choose(null);
        this.#digest.replaceChildren();
        this.#saves.forEach((button) => (button.disabled = true));
    }

    /** Renders the texts. A picture that is not finished is cancelled. */
    render(module: WebAssembly.Module, texts: Texts): void {
        this.#stop();
        this.#isBegun = false;
        this.#forget(texts);
        this.#cancel.disabled = false;
        this.#bar.hidden = false;
        this.#canvas.ariaBusy = 'true';
        this.#bar.removeAttribute('value');
        this.say(() => say('preparing'));
        const start = performance.now();
        let [size, shownWidth, rows] = [() => '', 0, 1];
        const failed = (text: string) => {
            this.#end();
            this.say(() => say('failed', text));
        };
        const worker = new Worker('worker.js', { type: 'module' });
        worker.onmessage = ({ data }: MessageEvent<Message>) => {
            switch (data.kind) {
                case 'begin': {
                    const { width, height, step } = data;
                    [shownWidth, rows] = [Math.ceil(width / step), height];
                    this.#canvas.ariaBusy = 'false';
                    this.#isBegun = true;
                    resize(this.#canvas, shownWidth, Math.ceil(height / step));
                    this.#canvas.dataset.step = String(step);
                    size = () => `${width} × ${height}${step > 1 ? ` (${say('shownPart', step)})` : ''}`;
                    this.#tell(() => `${say('rendering')} ${size()}`);
                    break;
                }
                case 'rows': {
                    const [share, seconds] = [data.done / rows, (performance.now() - start) / 1000];
                    this.#bar.value = share;
                    this.#bar.title = `${data.done} / ${rows} ${say('rows')}`;
                    const left = Math.ceil((seconds * (1 - share)) / share);
                    element('left').textContent = `${Math.floor(100 * share)} %${seconds > 1 ? `, ${say('timeLeft', left)}` : ''}`;
                    data.pixels.length > 0 && put(this.#canvas, new ImageData(data.pixels, shownWidth), data.first);
                    break;
                }
                case 'done':
                    this.#end();
                    this.#finish(data, size, ((performance.now() - start) / 1000).toFixed(2));
                    break;
                case 'fault':
                    this.#end();
                    this.onFault(data.fault);
                    break;
                case 'failed':
                    failed(data.text);
            }
        };
        worker.onerror = ({ message }) => failed(message || say('noModule', 'worker.js'));
        worker.postMessage({ module, ...texts } satisfies Task);
        this.#worker = worker;
    }

    /** Takes the finished picture. */
    #finish({ ppm, digest, vectors }: Message & { kind: 'done' }, size: () => string, seconds: string): void {
        [this.#ppm, this.#vectors] = [ppm, vectors];
        this.#saves.forEach((button) => (button.disabled = false));
        this.#tell(() => `${size()}, ${seconds} ${say('seconds')}`);
        const [code, same] = [document.createElement('code'), document.createElement('span')];
        code.textContent = digest;
        write(same, () => say('same'));
        this.#digest.replaceChildren('SHA-256 ', code, ' — ', same);
        this.onDone();
        void this.#view.renew();
    }

    /** Ends the worker. What it has already sent counts no more. */
    #stop(): void {
        if (this.#worker) {
            this.#worker.onmessage = this.#worker.onerror = null;
            this.#worker.terminate();
            this.#worker = null;
        }
    }

    /** Cancels the picture. The rows that are finished stay. */
    cancel(): void {
        if (this.#worker) {
            this.#end();
            this.say(() => say('cancelled'));
        }
    }

    /** Ends a picture. If nothing of it is shown, the one before is removed, which belongs to other texts. */
    #end(): void {
        if (!this.#isBegun) {
            erase(this.#canvas);
        }
        this.#stop();
        this.#canvas.ariaBusy = 'false';
        this.#cancel.disabled = true;
        this.#bar.hidden = true;
        element('left').textContent = '';
    }
}
