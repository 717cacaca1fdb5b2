// The path of a pixel: the steps by Rust and by the shaders side by side, and the ray's way in a plan of the scene.
import { Refused } from './gpu/device';
import type { Shaders } from './gpu/shaders';
import { definitions, linkTo, nameOf, objectName, type Definitions } from './definitions';
import type { Explained } from './explain';
import { plan } from './plan';
import { Faulty } from './module';
import type { Facts, Preparer } from './preparer';
import { developed, paint } from './shown';
import { limited } from './limited';
import { element, messageOf, say, write } from './words';

/** A scene with its camera, by both implementations. */
export interface Source {
    preparer: Preparer;
    shaders: Shaders | null;
    facts: Facts;
    /** The text of the scene. */
    scene: string;
    /** Whether the view still has this camera and size. */
    isCurrent(): boolean;
}

/** The numbers of a step that are shown: all but the background's colour for a hit, and other ones for an escape. */
const [HIT, ESCAPE] = [18, [0, 6, 7, 8, 9, 10, 11, 18, 19, 20]];

/** Names of numbers that have no fraction. */
const WHOLE = new Set(['is_hit', 'object', 'part', 'front', 'material']);

/** Returns the places of the numbers that are shown. `hit` is 1 for a hit, 0 for an escape, -1 after the end. */
function shown(hit: number): number[] {
    return hit === 1 ? Array.from({ length: HIT }, (_, place) => place) : hit === 0 ? ESCAPE : [];
}

const float = new Float32Array(1);
const word = new Uint32Array(float.buffer);

/** Returns the bits of a number with blanks between sign, exponent and fraction. */
function binary(number: number): string {
    float[0] = number;
    const digits = (word[0] ?? 0).toString(2).padStart(32, '0');
    return `${digits[0]} ${digits.slice(1, 9)} ${digits.slice(9)}`;
}

const same = (one: number, other: number): boolean => Object.is(one, other) || (Number.isNaN(one) && Number.isNaN(other));

/** Returns a number in the shortest form that has its bits. */
function text(number: number, name: string): string {
    if (WHOLE.has(name)) {
        return String(number);
    }
    for (let digits = 1; digits < 9; digits++) {
        if (Math.fround(Number(number.toPrecision(digits))) === number) {
            return String(Number(number.toPrecision(digits)));
        }
    }
    return Object.is(number, -0) ? '-0' : String(Number(number.toPrecision(9)));
}

/** Returns what a whole number of a step means, or nothing. `kind` is the first word of the object's line. */
function meaning(number: number, name: string, kind: string, { objects, materials }: Definitions): string {
    const [object, material] = [objects[number], materials[number]];
    switch (name) {
        case 'object': return object ? objectName(object) : '';
        case 'material': return material ? nameOf(material.name, material.line) : '';
        case 'part': return kind === 'cylinder' ? say((['side', 'top', 'bottom'] as const)[number] ?? 'side') : '';
        case 'front': return say(number === 1 ? 'outside' : 'inside');
        default: return '';
    }
}

/** The view of a pixel's path. */
export class PixelView {
    readonly #table = element('pixel-steps');
    readonly #inputs = ['column', 'row'].map((name) => element<HTMLInputElement>(`pixel-${name}`));
    readonly #picture = element<HTMLCanvasElement>('pixel-picture');
    /** The scene in deterministic light, for the facts of which it was rendered. */
    #image: { facts: Facts; image: ImageData } | null = null;
    #source: Source | null = null;
    #isRefused = false;
    /** The pixel of the exact picture that was followed last. */
    #clicked: Explained['place'] = null;
    #newest = 0;

    /**
     * `find` returns the scene of the live view, for a place that is typed before a pixel has been clicked. `refused` is
     * called when a shader is wrong (null: when it is right again), and `broken` when WebGPU does not work any more.
     */
    constructor(
        private readonly names: readonly string[],
        private readonly find: () => Promise<Source | null>,
        private readonly refused: (fault: Refused | null) => void,
        private readonly broken: (error: unknown) => void,
        private readonly goTo: (line: number) => void,
    ) {
        this.#inputs.forEach((input) => input.addEventListener('change', () => void this.refresh()));
        this.#picture.addEventListener('click', ({ offsetX, offsetY }) => {
            const { width, height, clientWidth, clientHeight } = this.#picture;
            if (this.#source) {
                const place = [(offsetX * width) / clientWidth, (offsetY * height) / clientHeight].map(Math.floor);
                void this.show(this.#source, ...place as [number, number]);
            }
        });
    }

    /** The column and the row of the pixel, or null if none is shown. */
    get place(): [number, number] | null {
        return this.#source && this.#inputs.map(({ value }) => Number(value)) as [number, number];
    }

    set place(place: [number, number]) {
        place.forEach((value, index) => (this.#inputs[index]!.value = String(value)));
    }

    /** Shows the path of a pixel. */
    async show(source: Source, column: number, row: number): Promise<void> {
        this.#source = source;
        this.place = [column, row];
        await this.refresh();
    }

    /** Forgets the scene, after the texts have changed. */
    forget(): void {
        this.#newest += 1;
        this.#source = null;
        this.#clear();
        this.#table.ariaBusy = 'false';
    }

    /** Follows the path in another scene, by another camera, or of the pixel that was clicked in the exact picture. */
    async renew(exact: Explained | null): Promise<void> {
        const isClicked = exact?.place && exact.place !== this.#clicked;
        if (isClicked || !this.#source?.isCurrent()) {
            this.#clicked = exact?.place ?? null;
            this.#source = null;
            await this.refresh(isClicked ? exact : null);
        }
    }

    /** Follows the path again, after a shader or the place has changed, which is the clicked one of `exact` if given. */
    async refresh(exact: Explained | null = null): Promise<void> {
        const own = ++this.#newest;
        this.#table.ariaBusy = 'true';
        const source = this.#source ?? await this.find();
        if (own !== this.#newest) {
            return;
        }
        if (!source) {
            this.#table.ariaBusy = 'false';
            return;
        }
        this.#source = source;
        const { width, height } = source.facts;
        if (exact?.place) {
            // The exact picture may have another size.
            const [column, row] = exact.place;
            const { pixels } = exact;
            this.place = [((column + 0.5) * width) / pixels.width, ((row + 0.5) * height) / pixels.height];
        }
        const [row, column] = [limited('pixel-row', 'row', height), limited('pixel-column', 'column', width)];
        const pixel = row * width + column;
        try {
            const rust = await source.preparer.steps(pixel);
            const wgsl = source.shaders ? await source.shaders.steps(pixel, this.names.length) : null;
            const probed = source.shaders ? await source.shaders.probed(pixel) : null;
            if (own === this.#newest) {
                this.#isRefused && this.refused(null);
                this.#isRefused = false;
                this.#fill(rust, wgsl, definitions(source.scene));
                element('pixel-probe').textContent = probed ? `probe: ${probed.map((value) => text(value, '')).join(', ')}` : '';
                const paths = [this.#points(rust), wgsl && this.#points(wgsl)] as const;
                element('pixel-plan').replaceChildren(plan(source.facts, ...paths));
                await this.#draw(source, column, row, () => own === this.#newest);
            }
        } catch (error) {
            if (own !== this.#newest) {
                return;
            }
            // The page must not show steps of an earlier version of the shaders.
            this.#clear();
            write(element('pixel-first'), () => messageOf(error));
            if (error instanceof Refused) {
                this.#isRefused = true;
                this.refused(error);
            } else if (source.shaders && !(error instanceof Faulty)) {
                this.broken(error);
            }
        }
        if (own === this.#newest) {
            this.#table.ariaBusy = 'false';
        }
    }

    /** Shows the scene in deterministic light, with a mark around the pixel. */
    async #draw({ facts, preparer }: Source, column: number, row: number, isCurrent: () => boolean): Promise<void> {
        if (this.#image?.facts !== facts) {
            this.#image = { facts, image: developed(await preparer.truth(0), facts) };
        }
        if (isCurrent()) {
            paint(this.#picture, this.#image.image);
            this.#picture.hidden = false;
            const size = Math.ceil(facts.width / 40);
            const context = this.#picture.getContext('2d') as CanvasRenderingContext2D;
            // The inverted colours are seen on every picture.
            Object.assign(context, { globalCompositeOperation: 'difference', strokeStyle: '#fff', lineWidth: size / 6 });
            context.strokeRect(column - size, row - size, 2 * size + 1, 2 * size + 1);
        }
    }

    #clear(): void {
        this.#picture.hidden = true;
        ['pixel-steps', 'pixel-plan', 'pixel-probe', 'pixel-first'].forEach((id) => element(id).replaceChildren());
    }

    #fill(rust: Float32Array, wgsl: Float32Array | null, known: Definitions): void {
        const numbers = this.names.length;
        const bodies: HTMLTableSectionElement[] = [];
        let first: { step: number; name: string; bits: string } | null = null;
        for (let step = 0; step * numbers < rust.length; step++) {
            const [own, other] = [rust, wgsl ?? rust].map((all) => all.subarray(step * numbers, (step + 1) * numbers));
            const places = new Set([...shown(own?.[0] ?? -1), ...shown(other?.[0] ?? -1)]);
            if (places.size === 0) {
                break;
            }
            const rows: HTMLTableRowElement[] = [];
            const kindOf = (step: Float32Array) => known.objects[step[this.names.indexOf('object')] ?? -1]?.tag ?? '';
            let [differing, group] = [0, ''];
            for (const place of [...places].sort((one, next) => one - next)) {
                const name = this.names[place] ?? '';
                const [a, b] = [own?.[place] ?? NaN, other?.[place] ?? NaN];
                const isSame = same(a, b);
                const mark = isSame ? '' : first ? 'differs' : 'first';
                const row = line([name, text(a, name), wgsl ? text(b, name) : '—'], mark);
                const cells = [[1, a, own], [2, b, wgsl && other]] as const;
                for (const [cell, number, step] of WHOLE.has(name) ? cells : []) {
                    const said = () => (step ? meaning(number, name, kindOf(step), known) : '');
                    const place = name === 'object' ? known.objects[number] : name === 'material' ? known.materials[number] : null;
                    const words = () => `${number} (${said()})`;
                    if (said() && place) {
                        row.cells[cell]?.replaceChildren(linkTo(place, words, this.goTo));
                    } else if (said()) {
                        write(row.cells[cell] as HTMLElement, words);
                    }
                }
                if (!isSame) {
                    differing += 1;
                    first ??= { step, name, bits: `\nRust  ${binary(a)}\nWGSL  ${binary(b)}` };
                }
                // The components of a vector stand together.
                const [vector = ''] = name.split('.');
                row.classList.toggle('group', vector !== group);
                group = vector;
                rows.push(row);
            }
            const title = wgsl ? differing > 0 ? 'stepDiffers' : 'stepSame' : 'stepAlone';
            bodies.push(folded(() => say(title, step, differing), rows));
        }
        const head = document.createElement('thead');
        head.append(line(['', 'Rust', 'WGSL'], ''));
        this.#table.replaceChildren(head, ...bodies);
        // The step with the first difference is open.
        bodies[first?.step ?? 0]?.querySelector('button')?.click();
        const found = first;
        write(element('pixel-first'), () => (found
            ? say('firstDifference', found.step, found.name) + found.bits
            : say(wgsl ? 'noDifference' : 'noShaders')));
    }

    /** The points of the path: where each ray starts, and a point on the way of the last one. */
    #points(steps: Float32Array): number[][] {
        const points: number[][] = [];
        for (let start = 0; start + this.names.length <= steps.length; start += this.names.length) {
            const at = (place: number) => Array.from(steps.subarray(start + place, start + place + 3));
            const hit = steps[start] ?? -1;
            if (hit < 0) {
                break;
            }
            points.push(at(6));
            const [origin, direction] = [at(6), at(9)];
            const length = Math.hypot(...direction) || 1;
            points.push(hit === 1 ? at(12) : origin.map((value, axis) => value + (3 * (direction[axis] ?? 0)) / length));
        }
        return points;
    }
}

/** Returns a row of the table. */
function line(cells: string[], name: string): HTMLTableRowElement {
    const row = document.createElement('tr');
    row.className = name;
    cells.forEach((content) => (row.insertCell().textContent = content));
    return row;
}

/** Returns the rows of a step below a button that shows and hides them. They are hidden at first. */
function folded(title: () => string, rows: HTMLTableRowElement[]): HTMLTableSectionElement {
    const body = document.createElement('tbody');
    const button = document.createElement('button');
    button.type = 'button';
    write(button, title);
    const fold = (isOpen: boolean) => {
        button.ariaExpanded = String(isOpen);
        rows.forEach((row) => (row.hidden = !isOpen));
    };
    button.addEventListener('click', () => fold(button.ariaExpanded === 'false'));
    const head = line([''], 'head');
    const cell = head.cells[0] as HTMLTableCellElement;
    cell.colSpan = 3;
    cell.append(button);
    body.append(head, ...rows);
    fold(false);
    return body;
}
