// The comparison: the picture by Rust and by the shaders with a slider between them, blinking, or their difference. Two
// pictures in files are compared in the same way.
import { compare, compareBytes, LARGEST, LEGEND, map, RMSE, type Difference } from './difference';
import { namedOf, type Named } from './files';
import { Refused } from './gpu/device';
import type { Shaders } from './gpu/shaders';
import type { Source } from './pixel';
import { Faulty } from './module';
import type { Facts, Preparer } from './preparer';
import { shown, type Rgb } from './ppm';
import { developed, erase, paint, shownConfig, shownWidth } from './shown';
import type { Texts } from './store';
import { Viewer } from './viewer';
import { element, messageOf, say, write } from './words';

/** Largest width of the pictures in pixels. */
const WIDTH = 480;

/** Time for which each of two blinking pictures is shown, in milliseconds. */
const BLINK = 600;

/** What the comparison tells the page. */
export interface Listener {
    refused(fault: Refused | null): void;
    /** WebGPU does not work any more. */
    broken(error: unknown): void;
    clicked(column: number, row: number): void;
    /** A pixel is chosen in a file and the exact picture. */
    chosen(column: number, row: number): void;
    /** The files are closed, so that the shaders are to be compared. */
    closed(): void;
}

/** The comparison. */
export class Comparison {
    readonly #exact = element<HTMLCanvasElement>('compare-exact');
    readonly #shader = element<HTMLCanvasElement>('compare-shader');
    readonly #map = element<HTMLCanvasElement>('compare-map');
    readonly #slider = element<HTMLInputElement>('compare-slider');
    readonly #blink = element<HTMLInputElement>('compare-blink');
    readonly #view = element<HTMLSelectElement>('compare-view');
    readonly #with = element<HTMLSelectElement>('compare-with');
    readonly #figures = element('compare-figures');
    #facts: Facts | null = null;
    /** The colours by Rust in f64 and in f32, when they are known. */
    #truths: (Float64Array | null)[] = [null, null];
    #difference: Difference | null = null;
    #scene = '';
    /** A file that is compared with the exact picture. */
    #alone: File | null = null;
    /** The picture of that file. */
    #beside: Named | null = null;
    /** The files that are compared instead of the shaders. */
    #names: [left: string, right: string] | null = null;
    #newest = 0;

    #shaders: Shaders | null = null;
    readonly #viewer: Viewer;

    constructor(private readonly preparer: Preparer, private readonly listener: Listener) {
        element('compare-legend').style.background = LEGEND;
        this.#slider.addEventListener('input', () => this.#cut());
        this.#view.addEventListener('change', () => this.#draw());
        this.#blink.addEventListener('change', () => this.#draw());
        this.#with.addEventListener('change', () => void this.refresh());
        element('compare-close').addEventListener('click', () => this.#close());
        this.#viewer = new Viewer(element('compare-stage'), {
            dragged: (x) => {
                if (!this.#slider.disabled) {
                    this.#slider.value = String(100 * x);
                    this.#cut();
                }
                return !this.#slider.disabled;
            },
            moved: () => this.#cut(),
            clicked: (column, row) => this.#clicked(column, row),
        });
        setInterval(() => this.#toggle(), BLINK);
        this.#cut();
    }

    /** The scene as it is compared, for the path of a pixel. */
    get source(): Source | null {
        const [facts, shaders] = [this.#facts, this.#shaders];
        return facts && { preparer: this.preparer, shaders, facts, scene: this.#scene, isCurrent: () => facts === this.#facts };
    }

    /** Compares these shaders from now on. Needs {@link show} afterwards. */
    set shaders(shaders: Shaders | null) {
        this.#newest += 1;
        this.#shaders = shaders;
        this.#facts = null;
        element('compare-pane').classList.toggle('without', shaders === null);
    }

    /** Removes the pictures, because another scene is loaded. */
    clear(): void {
        this.#name(null);
        this.#newest += 1;
        this.#facts = null;
        this.#difference = null;
        [this.#exact, this.#shader, this.#map].forEach(erase);
        this.#viewer.choose(null);
        this.#viewer.fit();
        write(this.#figures, () => '');
        element('compare-most-at').hidden = true;
    }

    /** Takes valid texts. */
    async show({ config, scene }: Texts): Promise<void> {
        const own = ++this.#newest;
        const shaders = this.#shaders;
        if (!shaders || this.#names) {
            return;
        }
        this.#exact.ariaBusy = 'true';
        try {
            const whole = await this.preparer.prepare({ config, scene });
            const aimed = await this.preparer.aim(shownConfig(config, shownWidth(whole.facts, WIDTH), null));
            if (own !== this.#newest) {
                return;
            }
            this.#facts = aimed.facts;
            this.#scene = scene;
            this.#truths = [null, null];
            shaders.load({ facts: aimed.facts, buffers: [...aimed.buffers, ...whole.buffers.slice(1)] });
            await this.refresh();
        } catch (error) {
            this.#failed(error);
        }
    }

    /** Renders by the shaders again, and compares. */
    async refresh(): Promise<void> {
        const own = ++this.#newest;
        const isCurrent = () => own === this.#newest;
        const [facts, shaders] = [this.#facts, this.#shaders];
        if (!facts || !shaders) {
            return;
        }
        try {
            this.#exact.ariaBusy = 'true';
            write(this.#figures, () => say('comparing'));
            const isRendered = await shaders.render('image', 0, isCurrent);
            const colors = await shaders.colors();
            if (!isCurrent()) {
                return;
            }
            this.listener.refused(null);
            const isSingle = this.#with.value === 'f32';
            const exact = this.#truths[isSingle ? 1 : 0] ?? await this.preparer.truth(isSingle ? 1 : 0);
            if (!isRendered || !isCurrent()) {
                return;
            }
            this.#truths[isSingle ? 1 : 0] = exact;
            this.#difference = compare(exact, colors);
            paint(this.#exact, developed(exact, facts));
            paint(this.#shader, developed(colors, facts));
            this.#draw();
            this.#exact.ariaBusy = 'false';
        } catch (error) {
            this.#failed(error);
        }
    }

    /** Compares two files, or one with the exact picture. */
    async showFiles(files: File[], exact: Rgb | null): Promise<void> {
        const own = ++this.#newest;
        try {
            const [first, second] = await namedOf(files);
            if (own !== this.#newest || !first) {
                return;
            }
            const other = second ?? (exact && { name: say('picture'), picture: exact });
            if (!other) {
                throw new Error(say('oneFile'));
            }
            const size = ({ name, picture }: typeof first) => [name, picture.width, picture.height] as const;
            if (first.picture.width !== other.picture.width || first.picture.height !== other.picture.height) {
                throw new Error(say('sizesDiffer', ...size(first), ...size(other)));
            }
            this.#name([first.name, other.name]);
            this.#alone = second ? null : files[0] ?? null;
            this.#beside = second ? null : first;
            this.#facts = null;
            this.#difference = compareBytes(first.picture.data, other.picture.data);
            paint(this.#exact, shown(first.picture, 1));
            paint(this.#shader, shown(other.picture, 1));
            this.#viewer.choose(null);
            this.#viewer.fit();
            this.#exact.ariaBusy = 'false';
            this.#draw();
        } catch (error) {
            // The comparison before stays.
            write(element('compare-fault'), () => messageOf(error));
        }
    }

    /** Compares a file that is compared with the exact picture again, because there is another one. */
    async renew(exact: Rgb | null): Promise<void> {
        if (this.#names && this.#alone && exact) {
            await this.showFiles([this.#alone], exact);
        }
    }

    /** Returns the name of the file that is compared with the exact picture `exact`, and its bytes at a pixel. */
    beside(column: number, row: number, exact: Rgb): { name: string; bytes: number[] } | null {
        if (!this.#names || !this.#beside) {
            return null;
        }
        const { name, picture: { data, width, height } } = this.#beside;
        if (width !== exact.width || height !== exact.height) {
            return null;
        }
        const start = 3 * (row * width + column);
        return { name, bytes: Array.from(data.subarray(start, start + 3)) };
    }

    /** Follows the path of a pixel, or chooses it for "Explain". Two files have no path. */
    #clicked(column: number, row: number): void {
        if (!this.#names) {
            this.listener.clicked(column, row);
        } else if (this.#beside) {
            this.listener.chosen(column, row);
        }
    }

    /** Compares the shaders again instead of files. */
    #close(): void {
        if (this.#names) {
            this.clear();
            this.listener.closed();
        }
    }

    #name(names: [left: string, right: string] | null): void {
        this.#names = names;
        element('compare-pane').classList.toggle('files', names !== null);
        write(element('compare-names'), () => (names ? say('filesNames', ...names) : ''));
        write(element('compare-fault'), () => '');
        if (names && this.#view.value === 'ulps') {
            this.#view.value = 'linear';
        }
        // Differences of bytes have no units in the last place. Some browsers show options that are hidden.
        element<HTMLOptionElement>('compare-ulps').disabled = names !== null;
    }

    #draw(): void {
        const difference = this.#difference;
        const isMap = this.#view.value !== 'both';
        this.#map.hidden = !isMap;
        element('compare-scale').hidden = !isMap;
        this.#slider.disabled = isMap || this.#blink.checked;
        this.#shader.style.visibility = 'visible';
        this.#cut();
        if (!difference) {
            return;
        }
        const isUlps = this.#view.value === 'ulps';
        if (isMap) {
            paint(this.#map, map(difference, isUlps, this.#exact.width));
        }
        write(element('compare-kind'), () => say(isUlps ? 'scaleLogarithmic' : 'scaleLinear'));
        const { differing, pixels, rmse, largest, largestUlps } = difference;
        const isAccepted = largest < LARGEST && rmse < RMSE;
        // Differences of bytes are up to 255, and those of linear colours are small.
        const [root, most] = [rmse, largest].map((one) => (this.#names ? one.toFixed(3) : one === 0 ? '0' : one.toExponential(2)));
        const key = !this.#names ? 'compareFigures' : isAccepted ? 'filesAccepted' : 'filesRefused';
        write(element('compare-most'), () => (isUlps ? say('ulps', largestUlps) : most ?? ''));
        // The place of the largest difference, by the numbers that the page shows.
        const [column, row] = [difference.place % this.#exact.width, Math.floor(difference.place / this.#exact.width)];
        const isBlind = !this.#names && Object.keys(this.#shaders?.edits ?? {}).length > 0;
        write(this.#figures, () => say(key, differing, pixels, root ?? '', most ?? '', largestUlps)
            + (isBlind ? ` ${say('compareBlind')}` : ''));
        const button = element('compare-most-at');
        button.hidden = differing === 0;
        write(button, () => say('compareMostAt', column, row));
        button.onclick = () => {
            this.#names ? this.#viewer.goTo(column, row) : this.#viewer.choose([column, row]);
            this.#clicked(column, row);
        };
        this.#figures.dataset.differing = String(differing);
    }

    /** Shows the shader's picture to the right of the slider. */
    #cut(): void {
        const left = this.#blink.checked ? 0 : Number(this.#slider.value);
        this.#shader.style.clipPath = `inset(0 0 0 ${100 * this.#viewer.partAt(left / 100)}%)`;
        element('compare-line').style.left = `${left}%`;
        element('compare-line').hidden = this.#blink.checked || this.#view.value !== 'both';
    }

    #toggle(): void {
        if (this.#blink.checked) {
            this.#shader.style.visibility = this.#shader.style.visibility === 'hidden' ? 'visible' : 'hidden';
        }
    }

    #failed(error: unknown): void {
        this.#exact.ariaBusy = 'false';
        if (error instanceof Refused) {
            this.listener.refused(error);
            write(this.#figures, () => say(this.#difference ? 'liveRefused' : 'liveRefusedFirst'));
        } else if (error instanceof Faulty) {
            write(this.#figures, () => error.say(this.#difference ? 'liveFault' : 'liveFaultFirst'));
        } else {
            this.listener.broken(error);
        }
    }
}
