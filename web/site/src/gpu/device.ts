// Opens WebGPU, compiles compositions, and runs them.
import { locate, type Composition, type ShaderFault } from './compose';

/** Smallest size of a buffer in bytes. It is more than any structure takes, so a binding is never too small. */
const SMALLEST = 256;

/** A compiled entry point. */
export interface Kernel {
    pipeline: GPUComputePipeline;
    layout: GPUBindGroupLayout;
}

/** A composition that does not compile. */
export class Refused extends Error {
    constructor(readonly faults: ShaderFault[]) {
        super(faults.map((fault) => `${fault.path}:${fault.line}: ${fault.message}`).join('\n'));
    }
}

/** A device with its name. */
export class Device {
    private constructor(readonly gpu: GPUDevice, readonly name: string) {}

    /** Opens the device of this browser, or returns null if it has none. */
    static async open(lost: (reason: string) => void): Promise<Device | null> {
        const adapter = await navigator.gpu?.requestAdapter().catch(() => null);
        if (!adapter) {
            return null;
        }
        const { maxStorageBufferBindingSize, maxBufferSize } = adapter.limits;
        const gpu = await adapter.requestDevice({ requiredLimits: { maxStorageBufferBindingSize, maxBufferSize } });
        void gpu.lost.then((info) => info.reason === 'destroyed' || lost(info.message));
        const { vendor, architecture, description } = adapter.info;
        return new Device(gpu, [vendor, architecture, description].filter(Boolean).join(' '));
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
        const info = await module.getCompilationInfo();
        const faults = info.messages.filter((message) => message.type === 'error').map((message) =>
            locate(composition, message.lineNum, message.linePos, message.length, message.message));
        let pipeline: GPUComputePipeline | null = null;
        let refusal = '';
        if (faults.length === 0) {
            const descriptor = {
                layout: this.gpu.createPipelineLayout({ bindGroupLayouts: [layout] }),
                compute: { module, entryPoint: entry, constants },
            };
            pipeline = await this.gpu.createComputePipelineAsync(descriptor).catch((error: unknown) => {
                refusal = error instanceof Error ? error.message : String(error);
                return null;
            });
        }
        const other = await this.gpu.popErrorScope();
        if (!pipeline) {
            throw new Refused(faults.length > 0 ? faults : [locate(composition, 0, 0, 0, refusal || (other?.message ?? ''))]);
        }
        return { pipeline, layout };
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
        await staging.mapAsync(GPUMapMode.READ);
        const bytes = staging.getMappedRange().slice(0, size);
        staging.destroy();
        return bytes;
    }
}
