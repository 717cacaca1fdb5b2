// Opens WebGPU, compiles compositions, and runs them.
import { messageOf, type Key } from '../words';
import { locate, type Composition, type ShaderFault } from './compose';

/** Smallest size of a buffer in bytes. It is more than any structure takes, so a binding is never too small. */
const SMALLEST = 256;

/** Time in which a browser must answer whether it has a device, in milliseconds. */
const PATIENCE = 15_000;

/** A compiled entry point. */
export interface Kernel {
    pipeline: GPUComputePipeline;
    layout: GPUBindGroupLayout;
    /** The user's loops, which end when they do not end themselves. */
    loops: readonly ShaderFault[];
}

/** A composition that does not compile. */
export class Refused extends Error {
    constructor(readonly faults: ShaderFault[]) {
        super(faults.map((fault) => `${fault.path}:${fault.line}: ${fault.message}`).join('\n'));
    }
}

/** WebGPU is missing or has failed. The key and the detail are a sentence of the page. */
export class Unavailable extends Error {
    constructor(readonly key: Key, readonly detail = '') {
        super(detail || key);
    }

    /** Returns the failure that an exception of WebGPU means. */
    static of(error: unknown): Unavailable {
        return error instanceof Unavailable ? error : new Unavailable('gpuFailed', messageOf(error));
    }
}

/** Returns what `work` gives. Throws {@link Unavailable} if that takes longer than {@link PATIENCE}. */
async function soon<T>(work: () => Promise<T>): Promise<T> {
    const late = new Promise<never>((_, reject) =>
        setTimeout(() => reject(new Unavailable('gpuSilent', String(PATIENCE / 1000))), PATIENCE));
    return Promise.race([work(), late]);
}

/** A device with its name. */
export class Device {
    /** Why the device does not work any more. */
    #failure: Unavailable | null = null;
    /** The functions that end the waiting for the device. A lost device may never answer. */
    readonly #waiting = new Set<(failure: Unavailable) => void>();
    /** Why the device has stopped to work, as soon as it does. */
    readonly failed: Promise<Unavailable>;

    private constructor(readonly gpu: GPUDevice, readonly name: string) {
        this.failed = new Promise((resolve) => {
            const fail = (failure: Unavailable) => {
                this.#failure ??= failure;
                this.#waiting.forEach((end) => end(failure));
                gpu.destroy();
                resolve(failure);
            };
            void gpu.lost.then(({ message }) => fail(new Unavailable('gpuLost', message)));
            gpu.addEventListener('uncapturederror', ({ error }) => fail(new Unavailable('gpuFailed', error.message)));
        });
    }

    /** Opens the device of this browser. Throws {@link Unavailable} if it has none, or if it fails. */
    static async open(): Promise<Device> {
        try {
            if (!navigator.gpu) {
                throw new Unavailable(isSecureContext ? 'gpuMissing' : 'gpuInsecure');
            }
            const adapter = await soon(async () => navigator.gpu.requestAdapter());
            if (!adapter) {
                throw new Unavailable('gpuNoAdapter');
            }
            const { maxStorageBufferBindingSize, maxBufferSize, maxStorageBuffersPerShaderStage } = adapter.limits;
            const requiredLimits = { maxStorageBufferBindingSize, maxBufferSize, maxStorageBuffersPerShaderStage };
            // Browsers that follow an early draft of WebGPU give null instead of an error.
            const gpu: GPUDevice | null = await soon(async () => adapter.requestDevice({ requiredLimits }));
            if (!gpu) {
                throw new Unavailable('gpuNoAdapter');
            }
            // Older browsers have no information about an adapter.
            const { vendor, architecture, description } = (adapter.info as GPUAdapterInfo | undefined) ?? {};
            return new Device(gpu, [vendor, architecture, description].filter(Boolean).join(' ') || 'WebGPU');
        } catch (error) {
            throw Unavailable.of(error);
        }
    }

    /** Returns what the device gives. Throws {@link Unavailable} when the device fails. */
    async wait<T>(work: Promise<T>): Promise<T> {
        if (this.#failure) {
            throw this.#failure;
        }
        return new Promise((resolve, reject) => {
            this.#waiting.add(reject);
            void work.then(resolve, reject).finally(() => this.#waiting.delete(reject));
        });
    }

    /**
     * Compiles the entry point `entry`. `written` says for each binding whether the shader writes it; null stands for a
     * binding that the shader does not have. Throws {@link Refused} if the text is wrong.
     */
    async compile(
        composition: Composition,
        entry: string,
        written: readonly (boolean | null)[],
        constants: Record<string, number> = {},
    ): Promise<Kernel> {
        this.gpu.pushErrorScope('validation');
        const module = this.gpu.createShaderModule({ code: composition.code });
        const layout = this.gpu.createBindGroupLayout({
            entries: written.flatMap((writes, binding) => (writes === null ? [] : [{
                binding,
                visibility: GPUShaderStage.COMPUTE,
                buffer: { type: writes ? 'storage' as const : 'read-only-storage' as const },
            }])),
        });
        const info = await this.wait(module.getCompilationInfo());
        const faults = info.messages.filter((message) => message.type === 'error').map((message) =>
            locate(composition, message.lineNum, message.linePos, message.length, message.message));
        let pipeline: GPUComputePipeline | null = null;
        let refusal = '';
        if (faults.length === 0) {
            const descriptor = {
                layout: this.gpu.createPipelineLayout({ bindGroupLayouts: [layout] }),
                compute: { module, entryPoint: entry, constants },
            };
            pipeline = await this.wait(this.gpu.createComputePipelineAsync(descriptor)).catch((error: unknown) => {
                // Any other error is one of the device, and not of the text.
                if (!(error instanceof GPUPipelineError && error.reason === 'validation')) {
                    throw error;
                }
                refusal = error.message;
                return null;
            });
        }
        const other = await this.wait(this.gpu.popErrorScope());
        if (!pipeline) {
            throw new Refused(faults.length > 0 ? faults : [locate(composition, 0, 0, 0, refusal || (other?.message ?? ''))]);
        }
        return { pipeline, layout, loops: composition.loops };
    }

    /** Returns a buffer for `content`: the bytes to read, or the number of bytes that a shader writes. */
    buffer(content: Uint8Array<ArrayBuffer> | number): GPUBuffer {
        const bytes = typeof content === 'number' ? null : content;
        const needed = typeof content === 'number' ? content : content.byteLength;
        const size = Math.max(Math.ceil(needed / 4) * 4, SMALLEST);
        const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC | GPUBufferUsage.COPY_DST;
        const buffer = this.gpu.createBuffer({ size, usage });
        if (bytes && bytes.byteLength > 0) {
            this.gpu.queue.writeBuffer(buffer, 0, bytes);
        }
        return buffer;
    }

    /** Adds a run of `kernel` to `encoder`. A null stands for a binding that the kernel does not have. */
    dispatch(encoder: GPUCommandEncoder, kernel: Kernel, buffers: readonly (GPUBuffer | null)[], invocations: number): void {
        const entries = buffers.flatMap((buffer, binding) => (buffer ? [{ binding, resource: { buffer } }] : []));
        const pass = encoder.beginComputePass();
        pass.setPipeline(kernel.pipeline);
        pass.setBindGroup(0, this.gpu.createBindGroup({ layout: kernel.layout, entries }));
        pass.dispatchWorkgroups(Math.ceil(invocations / 64));
        pass.end();
    }

    /** Returns the first `size` bytes of a buffer. `encoder` has the commands before the copy, which are submitted. */
    async read(encoder: GPUCommandEncoder, buffer: GPUBuffer, size: number): Promise<ArrayBuffer> {
        const usage = GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST;
        const staging = this.gpu.createBuffer({ size: Math.ceil(size / 4) * 4, usage });
        encoder.copyBufferToBuffer(buffer, 0, staging, 0, staging.size);
        this.gpu.queue.submit([encoder.finish()]);
        await this.wait(staging.mapAsync(GPUMapMode.READ));
        const bytes = staging.getMappedRange().slice(0, size);
        staging.destroy();
        return bytes;
    }
}
