// A link holds both texts in its fragment, which browsers do not send to a server: `#1:` and the compressed texts.
import type { Texts } from './store';

const START = '#1:';

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

/** Returns the link to this page with both texts. */
export async function make({ config, scene }: Texts): Promise<string> {
    const bytes = new TextEncoder().encode(JSON.stringify([config, scene]));
    const packed = await through(bytes, new CompressionStream('deflate-raw'));
    let binary = '';
    for (let start = 0; start < packed.length; start += PIECE) {
        binary += String.fromCharCode(...packed.subarray(start, start + PIECE));
    }
    const text = btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
    return `${location.origin}${location.pathname}${location.search}${START}${text}`;
}

/** Whether a fragment is one that {@link make} could have made. */
export function isLink(fragment: string): boolean {
    return fragment.startsWith(START);
}

/** Returns the texts of a fragment. Throws if it has none. */
export async function read(fragment: string): Promise<Texts> {
    const binary = atob(fragment.slice(START.length).replaceAll('-', '+').replaceAll('_', '/'));
    const packed = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    const bytes = await through(packed, new DecompressionStream('deflate-raw'));
    const texts: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
    if (!Array.isArray(texts) || typeof texts[0] !== 'string' || typeof texts[1] !== 'string') {
        throw new Error('the link has no texts');
    }
    return { config: texts[0], scene: texts[1] };
}
