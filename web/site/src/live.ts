// The live view: the picture of the shaders, turned by mouse, touch and keyboard. Without WebGPU a worker renders it.
import * as camera from './camera';
import type { Camera } from './camera';
import { Refused } from './gpu/device';
import { hasProbe as hasProbes } from './gpu/compose';
import type { Mode, Shaders } from './gpu/shaders';
import { definitions, objectName, type Definition } from './definitions';
import { Gestures } from './gestures';
import type { Source } from './pixel';
import { Faulty } from './module';
import type { Facts, Preparer } from './preparer';
import { developed, erase, paint, paintRows, shownConfig, shownWidth, TESTS } from './shown';
import { element, type Key, messageOf, say, write } from './words';

/** Largest width of the view in pixels, with WebGPU and without. */
const [WIDTH, WIDTH_WITHOUT] = [480, 160];

/** Number of samples at which the view stops to add more, as the noise is below a step of a byte then. */
const ENOUGH = 4096;

/** Times of a frame in milliseconds: the next one may have more pixels if it was fast, and fewer if it was slow. */
const [FAST, SLOW] = [100, 400];

/** Width of a picture from which on a slow frame has half as many pixels afterwards. */
const LEAST_WIDTH = 64;

/** Time without a change after which the picture gets its full size, in milliseconds. */
const REST = 300;

/** Time over which frames are counted, in milliseconds. */
const WINDOW = 1000;

/** What the view tells the page. */
export interface Listener {
    /** A shader does not compile (null: all of them do). */
    refused(fault: Refused | null): void;
    /** WebGPU does not work any more. */
    broken(error: unknown): void;
    /** The lines of the camera are wanted in the configuration, or also in its file. */
    taken(camera: Camera, isSaved: boolean): void;
    /** A place was clicked: parts of the picture's width and height. */
    clicked(x: number, y: number): void;
}

/** The view. */
export class Live {
    readonly #canvas = element<HTMLCanvasElement>('live-canvas');
    readonly #status = element('live-status');
    readonly #fixed = element<HTMLInputElement>('live-fixed');
    readonly #probes = element<HTMLInputElement>('live-probe');
    #config = '';
    #scene = '';
    #shaders: Shaders | null = null;
    #facts: Facts | null = null;
    /** The scene in its own size. */
    #whole: Facts | null = null;
    /** The largest number of tests in a frame of this device while something changes. */
    #tests = TESTS;
    /** Whether the last such frame was slow. */
    #isSlow = false;
    /** Whether the next frame has the full size, because nothing changes. */
    #isAtRest = false;
    /** Whether the canvas has a picture below the full size. */
    #isCoarse = false;
    /** The time of the last change. */
    #changed = 0;
    #camera: Camera | null = null;
    /** The camera of the configuration. */
    #start: Camera | null = null;
    #samples = 0;
    #isAimed = true;
    #isRunning = false;
    #isShown = false;
    /** Counts the changes of what is shown, and its value at the start of the last frame. */
    #version = 0;
    #seen = 0;
    /** The value that the picture shows. */
    #painted = 0;
    #isPreparing = false;
    #hasPicture = false;
    #isRefused = false;
    /** The smallest and the largest value that is probed. */
    #range: [number, number] = [0, 1];
    #times: number[] = [];
    /** The result of {@link #inside} for the last facts, as frames of one camera share it. */
    #around: { facts: Facts | null; object: Definition | undefined } = { facts: null, object: undefined };

    constructor(private readonly preparer: Preparer, private readonly listener: Listener) {
        this.#fixed.addEventListener('change', () => this.#restart());
        this.#probes.addEventListener('change', () => this.#restart());
        const take = (isSaved: boolean) => {
            if (this.#camera && this.#start) {
                listener.taken(camera.rounded(this.#camera, this.#start), isSaved);
            }
        };
        element('live-take').addEventListener('click', () => take(false));
        element('live-save').addEventListener('click', () => take(true));
        element('live-reset').addEventListener('click', () => this.#move(this.#start));
        new Gestures(this.#canvas, {
            // A drag over the whole picture turns the camera by half a circle.
            drag: (right, down) => this.#move(
                this.#camera && camera.orbit(this.#camera, right * Math.PI, down * Math.PI)),
            pan: (right, up) => this.#move(this.#camera && camera.pan(this.#camera, right, up)),
            zoom: (factor) => this.#move(this.#camera && camera.zoom(this.#camera, factor)),
            reset: () => this.#move(this.#start),
            click: ({ x, y }) => listener.clicked(x, y),
        });
    }

    /** The camera, if the user has moved it. */
    get moved(): Camera | null {
        return this.#camera === this.#start ? null : this.#camera;
    }

    set moved(moved: Camera | null) {
        this.#move(moved ?? this.#start);
    }

    /** Renders by these shaders from now on, or by the exact renderer without any. Needs {@link show} afterwards. */
    set shaders(shaders: Shaders | null) {
        this.#shaders = shaders;
        this.#facts = null;
        element('live-fixed-line').hidden = shaders === null;
    }

    /** Takes valid texts. The camera stays where it is if the configuration's camera has not changed. */
    async show(config: string, scene: string): Promise<void> {
        [this.#config, this.#scene] = [config, scene];
        this.#isPreparing = true;
        this.#mark();
        const shaders = this.#shaders;
        const isCurrent = () => shaders === this.#shaders && config === this.#config && scene === this.#scene;
        try {
            const whole = await this.preparer.prepare({ config, scene });
            if (!isCurrent()) {
                return;
            }
            const { position, target, north } = whole.facts;
            const start = { position, target, north };
            if (JSON.stringify(start) !== JSON.stringify(this.#start)) {
                this.#start = start;
                this.#camera = start;
            }
            this.#whole = whole.facts;
            this.#isAtRest = false;
            const prepared = await this.preparer.aim(this.#aimed(whole.facts));
            if (!isCurrent()) {
                return;
            }
            this.#facts = prepared.facts;
            shaders?.load({ facts: prepared.facts, buffers: [...prepared.buffers, ...whole.buffers.slice(1)] });
            this.#isPreparing = false;
            this.#restart();
        } catch (error) {
            if (isCurrent()) {
                this.#isPreparing = false;
                this.#failed(error);
            }
        }
    }

    /** Removes the picture, because another scene is loaded. */
    clear(): void {
        this.#hasPicture = false;
        this.#isCoarse = false;
        this.#facts = null;
        erase(this.#canvas);
        write(this.#status, () => say('busy'));
    }

    /** The scene as the view shows it, for the path of a pixel. */
    get source(): Source | null {
        const [facts, shaders] = [this.#facts, this.#shaders];
        return facts && { preparer: this.preparer, shaders, facts, scene: this.#scene, isCurrent: () => facts === this.#facts };
    }

    /** Waits until {@link source} has the moved camera and the full size. Throws {@link Faulty} if it has no picture. */
    async settle(): Promise<void> {
        this.#resize(true);
        await this.#settle();
    }

    async #settle(): Promise<void> {
        if (!this.#isAimed && this.#whole) {
            this.#isAimed = true;
            const aimed = await this.preparer.aim(this.#aimed(this.#whole)).catch((error: unknown) => {
                this.#isAimed = false;
                throw error;
            });
            this.#facts = aimed.facts;
            this.#shaders?.load(aimed);
        }
    }

    /** Compiles and renders again, after a shader has changed. */
    refresh(): void {
        this.#restart();
    }

    /** Renders while the view is shown. */
    set isShown(isShown: boolean) {
        this.#isShown = isShown;
        this.#restart();
    }

    #move(moved: Camera | null): void {
        if (moved) {
            this.#camera = moved;
            this.#isAimed = false;
            this.#restart();
        }
    }

    #restart(): void {
        this.#samples = 0;
        this.#changed = performance.now();
        this.#resize(false);
        this.#version += 1;
        this.#mark();
        this.#go();
    }

    /** Takes the full size for the next frame, or one in which frames are fast. */
    #resize(isAtRest: boolean): void {
        this.#isAimed &&= this.#isAtRest === isAtRest;
        this.#isAtRest = isAtRest;
    }

    /** Marks the picture as busy until it shows the last change in full size. Only an older picture is pale. */
    #mark(): void {
        const isOld = this.#isPreparing || (this.#facts !== null && this.#painted !== this.#version);
        this.#canvas.ariaBusy = String(isOld || this.#isCoarse);
        this.#canvas.dataset.old = String(isOld);
    }

    #go(): void {
        if (!this.#isRunning && this.#isShown && this.#facts) {
            this.#isRunning = true;
            void this.#run().catch((error: unknown) => this.#failed(error)).finally(() => {
                this.#isRunning = false;
                // A change may have come after the last frame had begun.
                if (this.#seen !== this.#version) {
                    this.#go();
                }
            });
        }
    }

    /** Renders frames until there is nothing to change. */
    async #run(): Promise<void> {
        const isWanted = () => this.#samples === 0 || this.#isCoarse || (this.#adds && this.#samples < ENOUGH);
        while (this.#isShown && this.#facts && isWanted()) {
            this.#seen = this.#version;
            // The time of a frame is without that of the compiler.
            await this.#shaders?.compile(this.#mode);
            const start = performance.now();
            if (this.#isCoarse && !this.#isPreparing && this.#samples > 0 && start - this.#changed > REST) {
                this.#samples = 0;
                this.#resize(true);
            }
            const isAtRest = this.#isAtRest;
            await this.#settle();
            const image = this.#shaders ? await this.#frame(this.#shaders, isAtRest) : await this.#slow();
            if (!this.#facts) {
                // Another scene has been loaded during the frame.
                return;
            }
            if (image) {
                paint(this.#canvas, image);
                this.#hasPicture = true;
                this.#isCoarse = image.width < this.#fullWidth;
                this.#painted = this.#seen;
                this.#mark();
            }
            // The next frame shows a change during this one.
            this.#samples = image && this.#seen === this.#version ? this.#samples + 1 : 0;
            if (image) {
                const duration = performance.now() - start;
                this.#tell(duration);
                this.#adapt(duration, isAtRest);
            }
            await new Promise(requestAnimationFrame);
        }
    }

    /** Takes a larger picture if the last one was fast, and a smaller one if two were slow while something changed. */
    #adapt(duration: number, isAtRest: boolean): void {
        if (isAtRest) {
            return;
        }
        const wasSlow = this.#isSlow;
        this.#isSlow = duration > SLOW && this.#samples <= 1 && this.#canvas.width >= LEAST_WIDTH;
        const isFast = duration < FAST && this.#isCoarse;
        if (isFast || (wasSlow && this.#isSlow)) {
            this.#tests *= isFast ? 2 : 1 / 2;
            this.#isSlow = false;
            this.#move(this.#camera);
        }
    }

    /** The width of the picture in full size. */
    get #fullWidth(): number {
        return this.#whole ? shownWidth(this.#whole, this.#largest, Infinity) : 0;
    }

    get #largest(): number {
        return this.#shaders ? WIDTH : WIDTH_WITHOUT;
    }

    get #adds(): boolean {
        return this.#shaders !== null && !this.#fixed.checked && !this.#isProbe;
    }

    /** Whether the view shows what a shader gives to `probe`. */
    get #isProbe(): boolean {
        return this.#probes.checked && Object.values(this.#shaders?.edits ?? {}).some(hasProbes);
    }

    async #frame(shaders: Shaders, isAtRest: boolean): Promise<ImageData | null> {
        const samples = this.#samples;
        const mode = this.#mode;
        const seen = this.#seen;
        const goesOn = async (done: number) => {
            if (isAtRest && samples === 0 && done > 0 && mode !== 'probe') {
                const image = await shaders.develop(1);
                if (image && seen === this.#version) {
                    paintRows(this.#canvas, image, Math.floor(done / image.width));
                }
            }
            // While the camera moves, each frame is shown.
            return !isAtRest || seen === this.#version;
        };
        // A run of a picture in full size takes as long as a frame while something changes.
        if (!await shaders.render(mode, samples, goesOn, isAtRest ? this.#tests : undefined)) {
            return null;
        }
        if (this.#isRefused) {
            this.#isRefused = false;
            this.listener.refused(null);
        }
        if (mode === 'probe') {
            this.#range = rangeOf(await shaders.colors());
            return shaders.develop(1, this.#range);
        }
        return shaders.develop(mode === 'accumulate' ? samples + 1 : 1);
    }

    /** What the next frame shows. */
    get #mode(): Mode {
        element('live-probe-line').hidden = !Object.values(this.#shaders?.edits ?? {}).some(hasProbes);
        return this.#isProbe ? 'probe' : this.#adds ? 'accumulate' : 'image';
    }

    /** A frame by the exact renderer in WebAssembly. */
    async #slow(): Promise<ImageData | null> {
        const facts = this.#facts;
        return facts && developed(await this.preparer.truth(0), facts);
    }

    /** The configuration with the camera and the size of the view. */
    #aimed(facts: Facts): string {
        const width = shownWidth(facts, this.#largest, this.#isAtRest ? Infinity : this.#tests);
        return shownConfig(this.#config, width, this.#camera);
    }

    /** Writes the status after a frame that took `duration` milliseconds. */
    #tell(duration: number): void {
        const now = performance.now();
        this.#times = [...this.#times.filter((time) => now - time < WINDOW), now];
        const first = this.#times[0] ?? now;
        // A single frame has no rate. If it takes longer than the window, its time is shown.
        const rate = this.#times.length > 1 ? ((this.#times.length - 1) * 1000) / (now - first) : null;
        const { width, height } = this.#canvas;
        const frames = Number(this.#canvas.dataset.frames ?? 0) + 1;
        this.#canvas.dataset.frames = String(frames);
        this.#canvas.dataset.samples = String(this.#samples);
        const samples = this.#adds ? this.#samples : null;
        const name = this.#shaders?.device.name ?? 'WebAssembly';
        const inside = this.#inside();
        const range = this.#isProbe ? this.#range.map((value) => value.toPrecision(4)) : null;
        write(this.#status, () => (inside ? `${say('liveInside', objectName(inside))} ` : '') + [
            `${width} × ${height}`,
            range ? say('probeRange', ...range) : samples === null ? say('lightFixed') : say('liveSamples', samples),
            rate !== null ? say('liveRate', rate.toFixed(1)) : '',
            rate === null && duration >= WINDOW ? say('liveDuration', (duration / 1000).toFixed(1)) : '',
            name,
        ].filter(Boolean).join(', '));
        const directions = this.#camera && camera.axes(this.#camera);
        write(element('live-axes'), () => (directions ? say('axes', ...directions.map((one) => say(`axis_${one}` as Key))) : ''));
    }

    /** The first object around the camera. Its surface may hide all light, and then the picture is black. */
    #inside(): Definition | undefined {
        const facts = this.#facts;
        if (facts && this.#around.facts !== facts) {
            const index = facts.shapes.findIndex((shape) => camera.isInside(facts.position, shape));
            const { objects } = index < 0 ? { objects: [] } : definitions(this.#scene);
            // The shapes are all spheres and then all cylinders.
            const sorted = ['sphere', 'cylinder'].flatMap((kind) => objects.filter(({ tag }) => tag === kind));
            this.#around = { facts, object: sorted[index] };
        }
        return this.#around.object;
    }

    #failed(error: unknown): void {
        this.#painted = this.#version;
        this.#isCoarse = false;
        this.#mark();
        const hasPicture = this.#hasPicture;
        if (error instanceof Refused) {
            this.#isRefused = true;
            this.listener.refused(error);
            write(this.#status, () => say(hasPicture ? 'liveRefused' : 'liveRefusedFirst'));
        } else if (error instanceof Faulty) {
            write(this.#status, () => error.say(hasPicture ? 'liveFault' : 'liveFaultFirst'));
        } else if (this.#shaders) {
            this.listener.broken(error);
        } else {
            write(this.#status, () => say('liveStopped', messageOf(error)));
        }
    }
}

/** Returns the smallest and the largest finite number, or 0 and 1 if all are the same. */
function rangeOf(numbers: Float32Array): [number, number] {
    let [low, high] = [Infinity, -Infinity];
    for (const number of numbers) {
        if (Number.isFinite(number)) {
            low = Math.min(low, number);
            high = Math.max(high, number);
        }
    }
    return low < high ? [low, high] : [0, 1];
}
