// A link holds the texts, the modules and the view in its fragment, which browsers do not send to a server: `#2:` and
// compressed JSON. Older links have `#1:` and both texts alone.
import { editsOf, type Texts } from './store';
import type { Vector } from './preparer';

/** What a link shows: a view, and the moved camera of the live view. */
export interface View {
    tab: string;
    camera: { position: Vector; target: Vector; north: Vector } | null;
    /** The pixel whose path is shown. */
    pixel: [column: number, row: number] | null;
}

/** What a link holds. */
export interface Shared extends Texts {
    view: View | null;
}

const [OLD, START] = ['#1:', '#2:'];

/** Largest size of the texts of a link in bytes. A small link could otherwise expand until the memory is full. */
const MAX_BYTES = 64 << 20;

/** Number of bytes that are converted to characters in one call. A call has a limited number of arguments. */
const PIECE = 1 << 15;

async function through(bytes: Uint8Array<ArrayBuffer>, stream: GenericTransformStream): Promise<Uint8Array<ArrayBuffer>> {
    const pieces: Uint8Array<ArrayBuffer>[] = [];
    let total = 0;
    const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
    for (;;) {
        const { done, value } = await reader.read();
        if (done) {
            break;
        }
        total += value.length;
        if (total > MAX_BYTES) {
            await reader.cancel();
            throw new Error('the texts of the link are too large');
        }
        pieces.push(value);
    }
    return new Uint8Array(await new Blob(pieces).arrayBuffer());
}

/** Returns the link to this page with the texts and the view. */
export async function make(shared: Shared): Promise<string> {
    const bytes = new TextEncoder().encode(JSON.stringify(shared));
    const packed = await through(bytes, new CompressionStream('deflate-raw'));
    let binary = '';
    for (let start = 0; start < packed.length; start += PIECE) {
        binary += String.fromCharCode(...packed.subarray(start, start + PIECE));
    }
    const text = btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
    return `${location.origin}${location.pathname}${START}${text}`;
}

/** Whether a fragment is one that {@link make} could have made. */
export function isLink(fragment: string): boolean {
    return fragment.startsWith(START) || fragment.startsWith(OLD);
}

/** Returns what a fragment holds. Throws if it has no texts. */
export async function read(fragment: string): Promise<Shared> {
    const binary = atob(fragment.slice(START.length).replaceAll('-', '+').replaceAll('_', '/'));
    const packed = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    const bytes = await through(packed, new DecompressionStream('deflate-raw'));
    const value: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
    const fields: Record<string, unknown> = Array.isArray(value)
        ? { config: value[0], scene: value[1] }
        : { ...(value as object), modules: editsOf((value as { modules?: unknown } | null)?.modules) };
    const { config, scene } = fields;
    if (typeof config !== 'string' || typeof scene !== 'string') {
        throw new Error('the link has no texts');
    }
    const texts = 'modules' in fields ? { config, scene, modules: fields.modules as Texts['modules'] ?? {} } : { config, scene };
    return { ...texts, view: viewOf(fields.view) };
}

/** Returns a view, or null if the value describes none. */
function viewOf(value: unknown): View | null {
    const { tab, camera, pixel } = (value ?? {}) as Partial<Record<keyof View, unknown>>;
    if (typeof tab !== 'string') {
        return null;
    }
    const isNumbers = (list: unknown, length: number): boolean =>
        Array.isArray(list) && list.length === length && list.every((one) => typeof one === 'number' && Number.isFinite(one));
    const vectors = (camera ?? {}) as Record<string, unknown>;
    const isCamera = ['position', 'target', 'north'].every((name) => isNumbers(vectors[name], 3));
    return {
        tab,
        camera: isCamera ? camera as View['camera'] : null,
        pixel: isNumbers(pixel, 2) ? pixel as View['pixel'] : null,
    };
}
