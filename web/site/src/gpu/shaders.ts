// Renders with the WGSL port: pictures in deterministic mode, frames that add up samples, and the steps of a pixel.
import type { Facts, Prepared } from '../preparer';
import { compose, ENDED, hasProbe, withoutEntry, type Composition, type Edits, type Module } from './compose';
import developSource from './develop.wgsl';
import { Refused, type Device, type Kernel } from './device';
import accumulateSource from './live.wgsl';
import probeSource from './probe.wgsl';

/** What a frame shows: a deterministic picture, added samples, or the value that a shader gives to `probe`. */
export type Mode = 'image' | 'accumulate' | 'probe';

/** The places of the first pixel and of the number of pixels in the structure Picture of picture.wgsl, in bytes. */
const [FIRST_PIXEL, PIXEL_COUNT] = [96, 100];

/** The binding of the hierarchy. */
const HIERARCHY = 8;

/** Largest number of pixels in one run, and of tests of a ray against an object, as gpu-check takes them. */
const [BATCH, TESTS] = [1 << 18, 2 ** 28];

/** Largest size of a buffer in bytes that every device has. */
const LARGEST = 1 << 27;

/** The names of the modules that each mode needs, and the page's own text after them. */
const ROOTS: Record<Mode, [roots: string[], own: string]> = {
    image: [['kernels/image'], ''],
    accumulate: [['bounce', 'uniform'], accumulateSource],
    probe: [['kernels/image'], probeSource],
};

/** The buffers of a scene on the device. */
interface Loaded {
    facts: Facts;
    head: Uint8Array<ArrayBuffer>;
    inputs: GPUBuffer[];
    /** The hierarchy, if the scene has many objects. */
    hierarchy: GPUBuffer | null;
    attenuations: GPUBuffer;
    colors: GPUBuffer;
    states: GPUBuffer;
    /** The largest number of pixels in one run. */
    batch: number;
}

/** The port on one device. */
export class Shaders {
    readonly #kernels = new Map<string, Promise<Kernel>>();
    readonly #frame: GPUBuffer;
    readonly #development: GPUBuffer;
    readonly #ended: GPUBuffer;
    #bytes: GPUBuffer | null = null;
    #loaded: Loaded | null = null;
    /** The user's texts, with which the next kernels are compiled. */
    edits: Edits = {};

    constructor(readonly device: Device, private readonly modules: readonly Module[]) {
        this.#frame = device.buffer(16);
        this.#development = device.buffer(24);
        this.#ended = device.buffer(4);
    }

    /** Gives a scene to the device. A scene with one buffer replaces the camera alone. */
    load({ facts, buffers }: Prepared): void {
        const [head, ...objects] = buffers.slice(0, 4);
        const tree = buffers[4];
        const old = this.#loaded;
        if (!head || (objects.length === 0 && !old)) {
            return;
        }
        const pixels = facts.width * facts.height;
        const batch = Math.min(BATCH, pixels, Math.floor(LARGEST / (4 * Math.max(facts.depth, 1))));
        const size = ({ width, height, depth }: Facts) => `${width * height} ${depth}`;
        const isSame = old && size(old.facts) === size(facts) && old.batch === batch;
        if (old && !isSame) {
            [old.attenuations, old.colors, old.states].forEach((buffer) => buffer.destroy());
            this.#bytes?.destroy();
            this.#bytes = null;
        }
        if (old && objects.length > 0) {
            [...old.inputs, old.hierarchy].forEach((buffer) => buffer?.destroy());
        }
        const inputs = objects.length > 0 ? [head, ...objects].map((bytes) => this.device.buffer(bytes)) : old?.inputs ?? [];
        const built = tree?.length ? this.device.buffer(tree) : null;
        const hierarchy = objects.length > 0 ? built : old?.hierarchy ?? null;
        const [attenuations, colors, states] = isSame
            ? [old.attenuations, old.colors, old.states]
            : [4 * batch * facts.depth, 12 * pixels, 32 * batch].map((size) => this.device.buffer(size));
        if (attenuations && colors && states) {
            this.#loaded = { facts, head, inputs, hierarchy, attenuations, colors, states, batch };
        }
    }

    /** Compiles a kernel with the user's texts. Throws {@link Refused} if they are wrong. */
    async compile(mode: Mode): Promise<Kernel> {
        const [roots, own] = ROOTS[mode];
        const composition = compose(this.modules, roots, this.edits, this.#hierarchy !== null, own);
        const runnable = mode === 'probe' ? withoutEntry(composition) : composition;
        const written = [false, false, false, false, true, true, mode !== 'accumulate'];
        return this.#compiled(runnable, mode, written, this.#constants());
    }

    /** The hierarchy, if the rays use it: the user may have another module that loops over all objects. */
    get #hierarchy(): GPUBuffer | null {
        return 'closest_hit' in this.edits ? null : this.#loaded?.hierarchy ?? null;
    }

    /** Returns the buffers of a kernel, with the hierarchy at its binding, and the number of a loop that was ended. */
    #bindings(kernel: Kernel, buffers: readonly GPUBuffer[]): (GPUBuffer | null)[] {
        const ended = kernel.loops.length > 0 ? this.#ended : null;
        return Object.assign([...buffers], { [HIERARCHY]: this.#hierarchy, [ENDED]: ended });
    }

    /** Selects the pixels of the next run. */
    #select({ head, inputs }: Loaded, first: number, count: number): void {
        const patched = head.slice();
        const view = new DataView(patched.buffer);
        view.setUint32(FIRST_PIXEL, first, true);
        view.setUint32(PIXEL_COUNT, count, true);
        this.device.gpu.queue.writeBuffer(inputs[0] as GPUBuffer, 0, patched);
    }

    /** Throws {@link Refused} if a loop of the kernel did not end itself. */
    async #check(kernel: Kernel): Promise<void> {
        if (kernel.loops.length > 0) {
            const [ended = 0] = new Uint32Array(await this.device.read(this.device.gpu.createCommandEncoder(), this.#ended, 4));
            const loop = kernel.loops[ended - 1];
            if (loop) {
                this.device.gpu.queue.writeBuffer(this.#ended, 0, new Uint32Array(1));
                throw new Refused([loop]);
            }
        }
    }

    /**
     * Renders a frame and keeps its linear colours on the device: sums of `frame + 1` samples for 'accumulate'. Each run
     * takes at most `most` tests. Between two runs `goesOn` gets the number of finished pixels, and says whether the
     * frame is still wanted. Returns whether the frame is complete.
     */
    async render(
        mode: Mode,
        frame: number,
        goesOn: (done: number) => boolean | Promise<boolean> = () => true,
        most = TESTS,
    ): Promise<boolean> {
        const inHierarchy = this.#hierarchy !== null;
        const kernel = await this.compile(mode);
        const isWanted = await goesOn(0);
        const loaded = this.#loaded;
        // Another scene may have been loaded meanwhile, for which this kernel is not made.
        if (!loaded || !isWanted || inHierarchy !== (this.#hierarchy !== null)) {
            return false;
        }
        const { gpu } = this.device;
        const { facts, inputs, attenuations, colors, states, batch } = loaded;
        const pixels = facts.width * facts.height;
        gpu.queue.writeBuffer(this.#frame, 0, new Uint32Array([frame]));
        const tests = this.#hierarchy ? facts.tests : facts.shapes.length;
        const run = Math.min(batch, Math.max(1024, Math.floor(most / Math.max(tests * facts.depth, 1))));
        const isWhole = run >= pixels;
        // The kernel of samples finds the sum of each pixel itself. The other ones begin with the first pixel of a run.
        const isInPlace = isWhole || mode === 'accumulate';
        const part = isInPlace ? colors : this.device.buffer(12 * run);
        let isComplete = true;
        for (let first = 0; first < pixels; first += run) {
            const count = Math.min(run, pixels - first);
            this.#select(loaded, first, count);
            const encoder = gpu.createCommandEncoder();
            const last = mode === 'accumulate' ? this.#frame : states;
            this.device.dispatch(encoder, kernel, this.#bindings(kernel, [...inputs, attenuations, part, last]), count);
            if (!isInPlace) {
                encoder.copyBufferToBuffer(part, 0, colors, 12 * first, 12 * count);
            }
            gpu.queue.submit([encoder.finish()]);
            if (!isWhole) {
                await this.device.wait(gpu.queue.onSubmittedWorkDone());
                // Another scene has destroyed the buffers of this one.
                if (!await goesOn(first + count) || this.#loaded !== loaded) {
                    isComplete = false;
                    break;
                }
            }
        }
        if (!isInPlace) {
            part.destroy();
        }
        await this.#check(kernel);
        return isComplete;
    }

    /** Returns the bytes of the last frame for a canvas. `range` shows values between two limits instead of colours. */
    async develop(samples: number, range: [low: number, high: number] | null = null): Promise<ImageData | null> {
        const composition = { code: developSource, parts: [], loops: [] };
        const kernel = await this.#compiled(composition, 'develop', [false, false, true], {});
        const loaded = this.#loaded;
        if (!loaded) {
            return null;
        }
        const { width, height, gamma } = loaded.facts;
        const pixels = width * height;
        const settings = new DataView(new ArrayBuffer(24));
        settings.setUint32(0, pixels, true);
        settings.setUint32(4, samples, true);
        settings.setFloat32(8, gamma, true);
        settings.setUint32(12, range ? 1 : 0, true);
        settings.setFloat32(16, range?.[0] ?? 0, true);
        settings.setFloat32(20, range?.[1] ?? 1, true);
        this.device.gpu.queue.writeBuffer(this.#development, 0, settings.buffer);
        this.#bytes ??= this.device.buffer(4 * pixels);
        const encoder = this.device.gpu.createCommandEncoder();
        this.device.dispatch(encoder, kernel, [this.#development, loaded.colors, this.#bytes], pixels);
        const bytes = await this.device.read(encoder, this.#bytes, 4 * pixels);
        return new ImageData(new Uint8ClampedArray(bytes), width, height);
    }

    /** Returns the linear colours of the last frame. */
    async colors(): Promise<Float32Array<ArrayBuffer>> {
        const loaded = this.#loaded;
        const size = loaded ? 12 * loaded.facts.width * loaded.facts.height : 0;
        if (!loaded || size === 0) {
            return new Float32Array(0);
        }
        return new Float32Array(await this.device.read(this.device.gpu.createCommandEncoder(), loaded.colors, size));
    }

    /** Returns the steps of a pixel's path: for each step as many numbers as `numbers` says. */
    async steps(pixel: number, numbers: number): Promise<Float32Array<ArrayBuffer>> {
        const inHierarchy = this.#hierarchy !== null;
        const composition = compose(this.modules, ['kernels/steps'], this.edits, inHierarchy);
        const written = [false, false, false, false, true, true];
        const kernel = await this.#compiled(composition, 'steps', written, this.#constants());
        const loaded = this.#loaded;
        if (!loaded || inHierarchy !== (this.#hierarchy !== null)) {
            return new Float32Array(0);
        }
        this.#select(loaded, pixel, 1);
        const size = 4 * numbers * loaded.facts.depth;
        const steps = this.device.buffer(size);
        const encoder = this.device.gpu.createCommandEncoder();
        this.device.dispatch(encoder, kernel, this.#bindings(kernel, [...loaded.inputs, loaded.attenuations, steps]), 1);
        const bytes = await this.device.read(encoder, steps, size);
        steps.destroy();
        await this.#check(kernel);
        return new Float32Array(bytes);
    }

    /** Returns the value that a shader gives to `probe` for a pixel, or null if no module calls it. */
    async probed(pixel: number): Promise<number[] | null> {
        if (!Object.values(this.edits).some(hasProbe) || !(await this.render('probe', 0))) {
            return null;
        }
        return Array.from((await this.colors()).subarray(3 * pixel, 3 * pixel + 3));
    }

    /** The constants of the scene's features. */
    #constants(): Record<string, number> {
        return Object.fromEntries(this.#loaded?.facts.constants ?? []);
    }

    /** Compiles a kernel once for each text and set of constants. `own` is without the binding of the hierarchy. */
    #compiled(
        composition: Composition,
        entry: string,
        own: readonly boolean[],
        constants: Record<string, number>,
    ): Promise<Kernel> {
        const inHierarchy = composition.parts.some(({ name }) => name === 'hierarchy');
        const written = Object.assign([...own], inHierarchy ? { [HIERARCHY]: false } : {},
            composition.loops.length > 0 ? { [ENDED]: true } : {});
        const key = `${entry} ${JSON.stringify(constants)} ${composition.code}`;
        const known = this.#kernels.get(key);
        if (known) {
            return known;
        }
        const entryPoint = entry === 'probe' ? 'probe_image' : entry;
        const kernel = this.device.compile(composition, entryPoint, written, constants);
        this.#kernels.set(key, kernel);
        // The oldest kernels give way, so that hours of editing do not fill the memory.
        for (const old of [...this.#kernels.keys()].slice(0, -12)) {
            this.#kernels.delete(old);
        }
        return kernel;
    }
}
