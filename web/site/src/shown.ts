// The size in which the shaders show a scene, and the bytes of linear colours.
import { lines, type Camera } from './camera';
import type { Facts } from './preparer';

/** Largest number of tests of a ray against an object in a picture. SwiftShader takes half a second for them. */
export const TESTS = 2 ** 26;

/** Returns the width of a picture of the shaders: at most `largest` pixels, and as wide as `most` tests allow. */
export function shownWidth({ width, height, tests, depth }: Facts, largest: number, most = TESTS): number {
    const affordable = Math.sqrt((most / Math.max(tests * depth, 1)) * (width / height));
    return Math.max(Math.min(width, largest, Math.floor(affordable)), Math.min(width, 16));
}

/**
 * Returns the configuration of a picture with this width, seen by `camera` if there is one. Of two lines with one key
 * the last one counts.
 */
export function shownConfig(config: string, shown: number, camera: Camera | null): string {
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

/** The event of a canvas whose pixels or size have changed. What the viewer around it says belongs to them. */
export const PAINTED = 'painted';

/** Shows rows of a picture in a canvas. */
export function put(canvas: HTMLCanvasElement, rows: ImageData, first: number): void {
    canvas.getContext('2d')?.putImageData(rows, 0, first);
    canvas.dispatchEvent(new Event(PAINTED, { bubbles: true }));
}

/** Gives a canvas the size of a picture, which clears it. The layout needs the ratio of the picture. */
export function resize(canvas: HTMLCanvasElement, width: number, height: number): void {
    [canvas.width, canvas.height] = [width, height];
    (canvas.closest<HTMLElement>('.viewer') ?? canvas).style.setProperty('--ratio', String(width / height));
    canvas.dispatchEvent(new Event(PAINTED, { bubbles: true }));
}

/** Removes the picture of a canvas, which keeps its size. */
export const erase = (canvas: HTMLCanvasElement): void => resize(canvas, canvas.width, canvas.height);

/** Shows the first `rows` rows of a picture. Below them is what the canvas has shown before. */
export function paintRows(canvas: HTMLCanvasElement, image: ImageData, rows: number): void {
    const { width, height } = image;
    if (canvas.width !== width) {
        const before = canvas.cloneNode() as HTMLCanvasElement;
        before.getContext('2d')?.drawImage(canvas, 0, 0);
        resize(canvas, width, height);
        canvas.getContext('2d')?.drawImage(before, 0, 0, width, height);
    }
    canvas.getContext('2d')?.putImageData(image, 0, 0, 0, 0, width, rows);
}

/** Shows a picture in a canvas of its size. */
export function paint(canvas: HTMLCanvasElement, image: ImageData): void {
    resize(canvas, image.width, image.height);
    put(canvas, image, 0);
}
