// Reads PPM (P3 and P6) and PNG, and converts the renderer's text to PNG.
import { say } from './words';

/** A picture with three bytes for each pixel. */
export interface Rgb {
    width: number;
    height: number;
    data: Uint8Array<ArrayBuffer>;
}

/** Largest number of pixels, as `render-lab compare` has it. A few bytes can announce a picture of any size. */
const MOST_PIXELS = 2 ** 26;

/** The first bytes of a PNG file, as characters. */
const PNG = '\x89PNG';

/** Returns the pixels of a file. Throws if it is no valid picture with 8 bits a channel. */
export async function readFile(bytes: Uint8Array): Promise<Rgb> {
    return String.fromCharCode(...bytes.subarray(0, 4)) === PNG ? fromPng(bytes) : read(bytes);
}

/** Returns the pixels of a PPM file. */
export function read(bytes: Uint8Array): Rgb {
    const variant = String.fromCharCode(...bytes.subarray(0, 2));
    if (variant !== 'P3' && variant !== 'P6') {
        throw new Error(say('noPicture'));
    }
    let at = 2;
    /** Returns the next number. A comment goes from # to the end of its line. */
    const number = (): number => {
        let isComment = false;
        for (; at < bytes.length && (isComment || (bytes[at] ?? 0) <= 32 || bytes[at] === 35); at++) {
            isComment = bytes[at] !== 10 && bytes[at] !== 13 && (isComment || bytes[at] === 35);
        }
        const start = at;
        let value = 0;
        for (let digit = (bytes[at] ?? 0) - 48; digit >= 0 && digit <= 9; digit = (bytes[++at] ?? 0) - 48) {
            value = value * 10 + digit;
        }
        return at > start ? value : NaN;
    };
    const [width, height, largest] = [number(), number(), number()];
    const count = 3 * width * height;
    if (largest !== 255 || !(count > 0 && count <= 3 * MOST_PIXELS && count <= bytes.length)) {
        throw new Error(say('brokenPicture'));
    }
    if (variant === 'P6') {
        // One byte of white space is between the header and the pixels.
        const data = bytes.slice(at + 1);
        if (data.length !== count) {
            throw new Error(say('brokenPicture'));
        }
        return { width, height, data };
    }
    const data = new Uint8Array(count);
    for (let place = 0; place < count; place++) {
        const value = number();
        if (!(value <= 255)) {
            throw new Error(say('brokenPicture'));
        }
        data[place] = value;
    }
    return { width, height, data };
}

async function fromPng(bytes: Uint8Array): Promise<Rgb> {
    const { convertIndexedToRgb, decode } = await import('fast-png');
    const [width, height] = [16, 20].map((place) => new DataView(bytes.buffer, bytes.byteOffset).getUint32(place));
    if (!width || !height || width * height > MOST_PIXELS) {
        throw new Error(say('brokenPicture'));
    }
    const png = decode(bytes);
    const isIndexed = png.palette !== undefined;
    if (png.depth !== 8 && !isIndexed) {
        throw new Error(say('noPicture'));
    }
    const colors = isIndexed ? convertIndexedToRgb(png) : png.data;
    const channels = colors.length / (width * height);
    const isGrey = channels < 3;
    const data = new Uint8Array(3 * width * height);
    for (let place = 0; place < data.length; place++) {
        data[place] = colors[Math.floor(place / 3) * channels + (isGrey ? 0 : place % 3)] ?? 0;
    }
    return { width, height, data };
}

/** Returns a PNG file with the pixels of a PPM text. */
export async function png(ppm: Uint8Array): Promise<Uint8Array<ArrayBuffer>> {
    // The first picture does not wait for this library.
    const { encode } = await import('fast-png');
    return encode({ ...read(ppm), channels: 3, depth: 8 }) as Uint8Array<ArrayBuffer>;
}

/** Returns every pixel whose row and column are multiples of `step`, with four bytes each. */
export function shown({ width, height, data }: Rgb, step: number): ImageData {
    const image = new ImageData(Math.ceil(width / step), Math.ceil(height / step));
    let to = 0;
    for (let row = 0; row < height; row += step) {
        for (let column = 0; column < width; column += step) {
            const from = 3 * (row * width + column);
            image.data.set([data[from] ?? 0, data[from + 1] ?? 0, data[from + 2] ?? 0, 255], to);
            to += 4;
        }
    }
    return image;
}
