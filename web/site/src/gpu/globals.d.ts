// What TypeScript does not know: WGSL files, which esbuild loads as texts, and the flags of WebGPU.
declare module '*.wgsl' {
    const text: string;
    export default text;
}
declare const GPUShaderStage: { COMPUTE: number };
declare const GPUBufferUsage: { STORAGE: number; COPY_SRC: number; COPY_DST: number; MAP_READ: number };
declare const GPUMapMode: { READ: number };
