// The size in which the shaders show a scene, and the bytes of linear colours.
import { lines, type Camera } from './camera';
import type { Facts } from './preparer';

/** Largest number of tests of a ray against an object in a picture. With more, it would take seconds. */
const TESTS = 2 ** 28;

/**
 * Returns the configuration of a picture of the shaders: at most `largest` pixels wide, and seen by `camera` if there
 * is one. Of two lines with one key the last one counts.
 */
export function shownConfig(config: string, facts: Facts, largest: number, camera: Camera | null): string {
    const { width, height, objects, depth } = facts;
    const affordable = Math.sqrt((TESTS / Math.max(objects * depth, 1)) * (width / height));
    const shown = Math.max(Math.min(width, largest, Math.floor(affordable)), Math.min(width, 16));
    const rows = camera ? lines(camera).map((row) => row.join(' ')) : [];
    return [config, `image_width: ${shown}`, ...rows, ''].join('\n');
}

/** Returns the picture of linear colours, with three numbers for each pixel. */
export function developed(colors: ArrayLike<number>, { width, height, gamma }: Facts): ImageData {
    const image = new ImageData(width, height);
    for (let pixel = 0; pixel < width * height; pixel++) {
        for (let channel = 0; channel < 3; channel++) {
            const mean = Math.min(Math.max(colors[3 * pixel + channel] ?? 0, 0), 1);
            image.data[4 * pixel + channel] = Math.floor(255 * mean ** (1 / gamma));
        }
        image.data[4 * pixel + 3] = 255;
    }
    return image;
}

/** Gives a canvas the size of a picture, which clears it. The layout needs the ratio of the picture. */
export function resize(canvas: HTMLCanvasElement, width: number, height: number): void {
    [canvas.width, canvas.height] = [width, height];
    (canvas.closest<HTMLElement>('.viewer') ?? canvas).style.setProperty('--ratio', String(width / height));
}

/** Shows a picture in a canvas of its size. */
export function paint(canvas: HTMLCanvasElement, image: ImageData): void {
    resize(canvas, image.width, image.height);
    canvas.getContext('2d')?.putImageData(image, 0, 0);
}
