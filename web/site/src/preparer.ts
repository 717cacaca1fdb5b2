// Asks a worker to read scenes for the shaders, and for the same pictures by Rust.
import { Asked } from './asked';
import { Faulty, faultOf, isFault, type Truth } from './module';
import type { Answer, Found, Request } from './preparing';
import type { Texts } from './store';

/** A vector: x, y and z. */
export type Vector = [number, number, number];

/** An object of the scene, for a plan of it. */
export type ShapeOf = [kind: 'sphere' | 'cylinder', center: Vector, radius: number, halfAxis: Vector];

/** What the page knows about a prepared scene besides its buffers. */
export interface Facts {
    width: number;
    height: number;
    gamma: number;
    depth: number;
    /** The cost of a ray in tests of a ray against an object. */
    tests: number;
    position: Vector;
    target: Vector;
    north: Vector;
    constants: [name: string, value: number][];
    shapes: ShapeOf[];
}

/** A scene for the shaders: its facts, the buffers with the bindings 0 to 3, and the hierarchy, which may be empty. */
export interface Prepared {
    facts: Facts;
    buffers: Uint8Array<ArrayBuffer>[];
}

/** A worker with one scene. */
export class Preparer {
    readonly #worker: Asked<{ request: Request }, Answer>;

    constructor(module: WebAssembly.Module) {
        this.#worker = new Asked('preparing.js', module);
    }

    /** Reads both texts. Throws {@link Faulty} if one of them is wrong. */
    async prepare({ config, scene }: Texts): Promise<Prepared> {
        return this.#prepared(await this.#ask({ kind: 'prepare', config, scene }));
    }

    /** Reads the configuration again for the scene of the last {@link prepare}. The result has one buffer. */
    async aim(config: string): Promise<Prepared> {
        return this.#prepared(await this.#ask({ kind: 'aim', config }));
    }

    /** Returns a picture in deterministic mode: three numbers for each pixel, or six of what its ray hits. */
    async truth(truth: Truth): Promise<Float64Array<ArrayBuffer>> {
        const { bytes } = await this.#ask({ kind: 'truth', number: truth });
        return new Float64Array(bytes[0]?.buffer ?? new ArrayBuffer(0));
    }

    /** Returns the steps of a pixel's path by Rust in f32. */
    async steps(pixel: number): Promise<Float32Array<ArrayBuffer>> {
        const { bytes } = await this.#ask({ kind: 'steps', number: pixel });
        return new Float32Array(bytes[0]?.buffer ?? new ArrayBuffer(0));
    }

    #prepared({ bytes, facts }: Found): Prepared {
        return { buffers: bytes, facts: JSON.parse(facts) as Facts };
    }

    async #ask(request: Request): Promise<Found> {
        const answer = await this.#worker.ask({ request }).catch(faultOf);
        if (isFault(answer)) {
            throw new Faulty(answer);
        }
        return answer;
    }
}
