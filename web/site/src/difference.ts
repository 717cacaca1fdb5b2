// The difference of the exact picture and of that of the shaders, in linear colours, and that of two files, in bytes.

/** The pixels of two pictures compared. */
export interface Difference {
    /** For each pixel the largest difference of a channel, and in units in the last place of f32. */
    linear: Float64Array<ArrayBuffer>;
    ulps: Float64Array<ArrayBuffer>;
    /** The number of pixels, and of those with a channel whose bits differ. */
    pixels: number;
    differing: number;
    rmse: number;
    largest: number;
    largestUlps: number;
    /** The number of the pixel with the largest difference. */
    place: number;
}

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** Returns the place of a number in the order of all f32. Neighbours have a distance of 1, and both zeros are 0. */
function orderOf(value: number): number {
    float[0] = value;
    const whole = bits[0] ?? 0;
    return whole >= 0 ? whole : -(whole & 0x7fffffff);
}

/** Returns the distance of two numbers in units in the last place. Two NaN have the distance 0. */
function ulpsOf(one: number, other: number): number {
    if (Number.isNaN(one) || Number.isNaN(other)) {
        return Number.isNaN(one) && Number.isNaN(other) ? 0 : Infinity;
    }
    return Math.abs(orderOf(one) - orderOf(other));
}

/** Compares the colours `exact`, rounded to f32, with those of the shaders. */
export function compare(exact: Float64Array, shader: Float32Array): Difference {
    const pixels = shader.length / 3;
    const [linear, ulps] = [new Float64Array(pixels), new Float64Array(pixels)];
    let [differing, squares, largest, largestUlps] = [0, 0, 0, 0];
    for (let pixel = 0; pixel < pixels; pixel++) {
        let [most, mostUlps] = [0, 0];
        for (let channel = 3 * pixel; channel < 3 * pixel + 3; channel++) {
            const [one, other] = [exact[channel] ?? 0, shader[channel] ?? 0];
            const distance = ulpsOf(Math.fround(one), other);
            const difference = Number.isNaN(one) && Number.isNaN(other) ? 0 : Math.abs(one - other);
            squares += difference ** 2;
            most = Math.max(most, distance === 0 ? 0 : difference);
            mostUlps = Math.max(mostUlps, distance);
            largest = Math.max(largest, difference);
        }
        linear[pixel] = most;
        ulps[pixel] = mostUlps;
        differing += mostUlps > 0 ? 1 : 0;
        largestUlps = Math.max(largestUlps, mostUlps);
    }
    const [rmse, place] = [Math.sqrt(squares / Math.max(shader.length, 1)), ulps.indexOf(largestUlps)];
    return { linear, ulps, pixels, differing, rmse, largest, largestUlps, place };
}

/** The limits of the course: it accepts a largest difference and an RMSE below them. */
export const [LARGEST, RMSE] = [150, 10];

/** Compares the bytes of two pictures. As in the course, the difference of a pixel is the mean of its channels'. */
export function compareBytes(one: Uint8Array, other: Uint8Array): Difference {
    const linear = new Float64Array(one.length / 3).map((_, pixel) => [0, 1, 2].reduce((sum, channel) => (
        sum + Math.abs((one[3 * pixel + channel] ?? 0) - (other[3 * pixel + channel] ?? 0))), 0) / 3);
    const [squares, largest] = linear.reduce(([sum, most], value) => [sum + value ** 2, Math.max(most, value)], [0, 0]);
    const pixels = linear.length;
    const differing = linear.filter((value) => value > 0).length;
    const [rmse, place] = [Math.sqrt(squares / pixels), linear.indexOf(largest)];
    return { linear, ulps: linear, pixels, differing, rmse, largest, largestUlps: 0, place };
}

/** The colours of the map from no difference to the largest one. */
const SCALE: [number, number, number][] = [[0, 0, 0], [60, 20, 140], [220, 60, 60], [250, 180, 50], [255, 255, 220]];

/** The map's colours for the page's legend. */
export const LEGEND = `linear-gradient(to right, ${SCALE.map((color) => `rgb(${color.join()})`).join()})`;

/** Returns the map of a difference. Units in the last place have a logarithmic scale. */
export function map(difference: Difference, isUlps: boolean, width: number): ImageData {
    const image = new ImageData(width, difference.pixels / width);
    const scaled = (value: number) => (isUlps ? Math.log2(1 + Math.min(value, 2 ** 31)) : value);
    const most = scaled(isUlps ? difference.largestUlps : difference.largest) || 1;
    (isUlps ? difference.ulps : difference.linear).forEach((value, pixel) => {
        // A difference is visible even where it is small beside the largest one.
        const part = value > 0 ? 0.15 + 0.85 * Math.min(scaled(value) / most, 1) : 0;
        const step = Math.min(Math.floor(part * (SCALE.length - 1)), SCALE.length - 2);
        const [low, high] = [SCALE[step] ?? [0, 0, 0], SCALE[step + 1] ?? [0, 0, 0]];
        const rest = part * (SCALE.length - 1) - step;
        low.forEach((channel, index) => {
            image.data[4 * pixel + index] = channel + ((high[index] ?? 0) - channel) * rest;
        });
        image.data[4 * pixel + 3] = 255;
    });
    return image;
}
