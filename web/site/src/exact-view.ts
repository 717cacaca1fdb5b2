// Other views of the exact picture: distance, normals, objects and rays, with a scale. A click goes to an object's line.
import { definitions, objectName, type Definition } from './definitions';
import { Preparer, type Facts } from './preparer';
import { shownConfig, shownWidth } from './shown';
import type { Texts } from './store';
import { element, say, write } from './words';

/** Largest width of a view in pixels. */
const WIDTH = 1280;

/** The numbers of a pixel, and the places of the distance, the object and the rays among them. */
const [NUMBERS, PLACES] = [6, { depth: 0, object: 4, cost: 5 }] as const;

type Kind = 'picture' | 'depth' | 'normal' | 'object' | 'cost';

/** What the rays through the middles of a picture's pixels hit. `whole` is the width of the picture. */
interface Seen {
    texts: Texts;
    facts: Facts;
    whole: number;
    numbers: Float64Array;
    objects: Definition[];
}

/** What the views need of the page. */
export interface Owner {
    /** The texts of the picture. */
    texts(): Texts | null;
    /** Shows a picture, or the exact one again. */
    paint(image: ImageData | null, step: number): void;
    goTo(line: number): void;
    say(text: () => string): void;
}

/** The views. */
export class ExactView {
    readonly #select = element<HTMLSelectElement>('exact-view');
    readonly #limits = [element<HTMLInputElement>('exact-low'), element<HTMLInputElement>('exact-high')] as const;
    #preparer: Preparer | null = null;
    #seen: Seen | null = null;

    constructor(private readonly module: () => WebAssembly.Module, private readonly owner: Owner) {
        this.#select.addEventListener('change', () => void this.renew());
        this.#limits.forEach((input) => input.addEventListener('change', () => void this.#draw(false)));
        const exposure = element<HTMLInputElement>('exposure');
        exposure.addEventListener('input', () => {
            // A byte is a power of the light, so a factor of the light is a factor of all bytes.
            const gamma = Number(/.*^\s*gamma:\s*(\S+)/ms.exec(owner.texts()?.config ?? '')?.[1] ?? 2.2);
            element('canvas').style.filter = `brightness(${2 ** (Number(exposure.value) / gamma)})`;
        });
    }

    /** Shows the chosen view of the picture, which may be new. */
    renew(): Promise<void> {
        return this.#draw(true);
    }

    /** Returns what the view shows at a pixel, or null for the colours of the picture. */
    told(column: number, row: number): string | null {
        const [seen, kind] = [this.#seen, this.#select.value as Kind];
        if (!seen || kind === 'picture') {
            return null;
        }
        const at = NUMBERS * (row * seen.facts.width + column);
        const [depth = NaN, x = 0, y = 0, z = 0, object = 0, rays = 0] = seen.numbers.subarray(at, at + NUMBERS);
        const one = seen.objects[object];
        const what = { depth: depth.toPrecision(7), normal: [x, y, z].map((part) => part.toFixed(4)).join(' '),
            object: one ? objectName(one) : '', cost: String(rays) }[kind];
        return Number.isNaN(depth) && kind !== 'cost' ? say('background') : what;
    }

    /** Goes to the line of the object at a pixel of the picture. */
    async clicked(column: number, row: number): Promise<void> {
        const seen = await this.#see();
        if (!seen) {
            return;
        }
        // The view may be narrower than the picture. A quotient may be a little below the whole number that it means.
        const [x = 0, y = 0] = [column, row].map((place) => Math.floor((place * seen.facts.width) / seen.whole + 1e-6));
        const one = seen.objects[seen.numbers[NUMBERS * (y * seen.facts.width + x) + PLACES.object] ?? -1];
        one && this.owner.goTo(one.line);
        this.owner.say(() => say('pixelAt', column, row, one ? objectName(one) : say('background')));
    }

    /** Traces one ray through the middle of each pixel, once for each picture. */
    async #see(): Promise<Seen | null> {
        const texts = this.owner.texts();
        if (texts && this.#seen?.texts !== texts) {
            this.#preparer ??= new Preparer(this.module());
            const { facts: whole } = await this.#preparer.prepare(texts);
            const width = shownWidth(whole, WIDTH, Infinity);
            const { facts } = width < whole.width ? await this.#preparer.aim(shownConfig(texts.config, width, null)) : { facts: whole };
            const [numbers, { objects }] = [await this.#preparer.truth(2), definitions(texts.scene)];
            this.#seen = { texts, facts, whole: whole.width, numbers, objects };
        }
        return texts && this.#seen;
    }

    async #draw(isNew: boolean): Promise<void> {
        const kind = this.#select.value as Kind;
        const isScaled = kind === 'depth' || kind === 'cost';
        element('exact-scale').hidden = kind === 'picture';
        element('exact-range').hidden = !isScaled;
        element('exposure-line').hidden = kind !== 'picture';
        write(element('exact-unit'), () => (kind === 'picture' ? '' : say(`${kind}Unit`)));
        const seen = kind === 'picture' ? null : await this.#see();
        if (!seen) {
            this.owner.paint(null, 1);
            return;
        }
        const { facts: { width, height }, numbers } = seen;
        const place = isScaled ? PLACES[kind] : 0;
        const [low, high] = this.#limits;
        if (isScaled && isNew) {
            const all = numbers.filter((number, index) => index % NUMBERS === place && !Number.isNaN(number));
            low.value = String(Number(all.reduce((one, other) => Math.min(one, other), Infinity).toPrecision(4)));
            high.value = String(Number(all.reduce((one, other) => Math.max(one, other), 0).toPrecision(4)));
        }
        const [from, to] = [Number(low.value), Number(high.value)];
        const image = new ImageData(width, height);
        for (let pixel = 0; pixel < width * height; pixel++) {
            const at = NUMBERS * pixel;
            const value = numbers[at + place] ?? 0;
            // A scene has few objects, and a ground that ends far away.
            const part = kind === 'depth' ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from);
            const grey = 255 * part || 0;
            const color = isScaled ? [grey, grey, grey]
                : kind === 'object' ? colorOf(numbers[at + PLACES.object] ?? 0)
                : [1, 2, 3].map((axis) => 127.5 * (1 + (numbers[at + axis] ?? 0)));
            image.data.set([...color, Number.isNaN(numbers[at]) && kind !== 'cost' ? 0 : 255], 4 * pixel);
        }
        this.owner.paint(image, seen.whole / width);
    }
}

/** Returns the colour of an object. The golden angle between two hues keeps those of neighbours apart. */
function colorOf(object: number): number[] {
    const channel = (shift: number) => 60 + 90 * (1 + Math.cos((2 * Math.PI * (object * 137.508 + shift)) / 360));
    return [channel(0), channel(240), channel(120)];
}
