// Reads the PPM text of the renderer, and converts it to PNG.
import { encode } from 'fast-png';

/** A picture with three bytes for each pixel. */
export interface Rgb {
    width: number;
    height: number;
    data: Uint8Array<ArrayBuffer>;
}

/** Returns the pixels of a PPM text of the renderer (variant P3). Throws if the text has too few numbers. */
export function read(ppm: Uint8Array): Rgb {
    const head = /^P3\n(\d+) (\d+)\n255\n/.exec(new TextDecoder().decode(ppm.subarray(0, 64)));
    if (!head) {
        throw new Error('this is no PPM text');
    }
    const [width, height] = [Number(head[1]), Number(head[2])];
    const data = new Uint8Array(3 * width * height);
    let place = 0;
    let number = -1;
    for (let index = head[0].length; index < ppm.length; index++) {
        const digit = (ppm[index] ?? 0) - 48;
        if (digit >= 0) {
            number = Math.max(number, 0) * 10 + digit;
        } else if (number >= 0) {
            data[place++] = number;
            number = -1;
        }
    }
    if (place !== data.length) {
        throw new Error(`${place} numbers instead of ${data.length}`);
    }
    return { width, height, data };
}

/** Returns a PNG file with the pixels of a PPM text. */
export function png(ppm: Uint8Array): Uint8Array<ArrayBuffer> {
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
