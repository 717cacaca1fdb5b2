// Compiles and runs shaders by WebGPU. This file does not use the page.

const STORAGE = 0x80, COPY_SRC = 0x4, COPY_DST = 0x8, MAP_READ = 0x1;
// Least size of a buffer in bytes, since no buffer may be empty. It is more than any structure takes.
const SMALLEST = 256;

export async function openDevice() {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) throw new Error("this browser gives no WebGPU adapter; Chromium on Linux needs --enable-unsafe-webgpu");
    const { vendor, architecture, device, description } = adapter.info;
    const name = [vendor, architecture, device, description].filter(Boolean).join(" ");
    return { device: await adapter.requestDevice(), name };
}

// A fault in a shader.
export class ShaderFault extends Error {}

// Compiles the entry point `entry`; `written` says for each binding whether the shader writes it.
export async function compile(device, code, entry, written, constants) {
    device.pushErrorScope("validation");
    const module = device.createShaderModule({ code });
    const fault = (await module.getCompilationInfo()).messages.find((message) => message.type === "error");
    const layout = device.createBindGroupLayout({
        entries: written.map((writes, binding) => ({
            binding,
            visibility: GPUShaderStage.COMPUTE,
            buffer: { type: writes ? "storage" : "read-only-storage" },
        })),
    });
    let pipeline, refusal;
    if (!fault) {
        const descriptor = {
            layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
            compute: { module, entryPoint: entry, constants },
        };
        pipeline = await device.createComputePipelineAsync(descriptor).catch((error) => { refusal = error.message; });
    }
    const other = await device.popErrorScope();
    if (fault) throw new ShaderFault(fault.message);
    if (refusal || other) throw new ShaderFault(refusal || other.message);
    return { pipeline, layout };
}

// Runs a pipeline with a buffer for each of `contents`, which is either the bytes to read or the number of bytes that
// the shader writes. Returns the bytes of the buffer numbered `output`.
export async function run(device, { pipeline, layout }, contents, output, invocations) {
    const buffers = contents.map((content) => {
        const bytes = typeof content === "number" ? null : content;
        const size = Math.max(bytes ? bytes.byteLength : content, SMALLEST);
        const buffer = device.createBuffer({ size, usage: STORAGE | COPY_SRC | COPY_DST });
        if (bytes?.byteLength) device.queue.writeBuffer(buffer, 0, bytes);
        return buffer;
    });
    const entries = buffers.map((buffer, binding) => ({ binding, resource: { buffer } }));
    const staging = device.createBuffer({ size: buffers[output].size, usage: MAP_READ | COPY_DST });
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({ layout, entries }));
    pass.dispatchWorkgroups(Math.ceil(invocations / 64));
    pass.end();
    encoder.copyBufferToBuffer(buffers[output], 0, staging, 0, staging.size);
    device.queue.submit([encoder.finish()]);
    await staging.mapAsync(1);
    const bytes = staging.getMappedRange().slice(0, contents[output]);
    [...buffers, staging].forEach((buffer) => buffer.destroy());
    return bytes;
}
