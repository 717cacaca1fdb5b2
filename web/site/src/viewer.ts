// A picture that is zoomed and moved, with the numbers of the pixel under the pointer. A stage holds one picture, or
// two of the same size on top of each other.
import { Gestures, type Place } from './gestures';
import { PAINTED } from './shown';
import { say, write } from './words';

/** The largest size of a pixel of the picture, in pixels of the screen. */
const LARGEST = 64;

/** The size of a pixel of the picture that {@link Viewer.goTo} shows, in pixels of the screen. */
const NEAR = 8;

/** What a viewer tells its owner. */
export interface Owner {
    /** Takes a drag to `x` in the stage, from 0 to 1, and returns true. Otherwise the drag moves the picture. */
    dragged?(x: number): boolean;
    /** The picture has another size or place. */
    moved?(): void;
    clicked?(column: number, row: number): void;
    /** Returns what is told about a pixel instead of its colours, or null. */
    told?(column: number, row: number): string | null;
}

/** The viewer of a stage. */
export class Viewer {
    /** The picture's width in widths of the stage, and its left upper corner in parts of the stage. */
    #zoom = 1;
    #corner: Place = { x: 0, y: 0 };
    /** The place in the stage whose pixel is told. */
    #told: Place | null = null;
    /** The middle of the pixel that was clicked last, in parts of the picture, and the frame around it. */
    #chosen: Place | null = null;
    readonly #frame = document.createElement('div');
    readonly #canvases: HTMLCanvasElement[];
    readonly #scale = document.createElement('span');
    readonly #pixel = document.createElement('span');

    constructor(private readonly stage: HTMLElement, private readonly owner: Owner) {
        this.#canvases = Array.from(stage.querySelectorAll('canvas')).slice(0, 2);
        const gestures = new Gestures(stage, {
            drag: (right, down, at) => at && owner.dragged?.(at.x) || this.#pan(-right, down),
            pan: (right, up) => this.#pan(right, up),
            zoom: (factor, at) => this.#zoomTo(this.#zoom / factor, at),
            reset: () => this.fit(),
            click: (at) => {
                this.#told = at;
                this.#tell();
                const pixel = this.#pixelAt(at);
                if (pixel && owner.clicked) {
                    this.choose(pixel);
                    owner.clicked(...pixel);
                }
            },
        });
        this.#frame.className = 'chosen';
        stage.append(this.#frame);
        stage.addEventListener('pointermove', (event) => {
            this.#told = gestures.placeOf(event);
            this.#tell();
        });
        stage.addEventListener(PAINTED, () => this.#show());
        const button = (name: string, text: () => string, act: () => void) => {
            const made = document.createElement('button');
            made.type = 'button';
            made.id = `${stage.id}-${name}`;
            write(made, text);
            made.addEventListener('click', act);
            return made;
        };
        const tools = document.createElement('div');
        tools.className = 'viewing';
        tools.append(
            button('fit', () => say('fit'), () => this.fit()),
            button('actual', () => '1:1', () => this.#zoomTo(this.#actual, null)),
            this.#scale,
            this.#pixel,
        );
        stage.after(tools);
        new ResizeObserver(() => this.#show()).observe(stage);
    }

    /** Draws a frame around a pixel, or around none. */
    choose(pixel: [column: number, row: number] | null): void {
        const { width, height } = this.#size;
        this.#chosen = pixel && { x: (pixel[0] + 0.5) / width, y: (pixel[1] + 0.5) / height };
        this.#show();
    }

    /** The size of the picture. */
    get #size(): { width: number; height: number } {
        return this.#canvases[0] ?? { width: 1, height: 1 };
    }

    /** Shows the whole picture. */
    fit(): void {
        this.#zoomTo(1, null);
    }

    /** Shows a pixel of the picture in the middle, enlarged, with its numbers. */
    goTo(column: number, row: number): void {
        const { width, height } = this.#size;
        this.fit();
        this.choose([column, row]);
        this.#zoomTo(Math.max(NEAR * this.#actual, 1), null);
        this.#corner = { x: 0.5 - ((column + 0.5) * this.#zoom) / width, y: 0.5 - ((row + 0.5) * this.#zoom) / height };
        this.#show();
        this.#told = { x: this.#corner.x + ((column + 0.5) * this.#zoom) / width,
            y: this.#corner.y + ((row + 0.5) * this.#zoom) / height };
        this.#tell();
    }

    /** Returns the part of the picture's width at `x`, a part of the stage's width. */
    partAt(x: number): number {
        return Math.min(Math.max((x - this.#corner.x) / this.#zoom, 0), 1);
    }

    /** The zoom at which a pixel of the picture has the size of a pixel of the screen. */
    get #actual(): number {
        return (this.#canvases[0]?.width ?? 1) / Math.max(this.stage.clientWidth * devicePixelRatio, 1);
    }

    /** Zooms and keeps what is at the place `at`, or in the middle. */
    #zoomTo(zoom: number, at: Place | null): void {
        const { x, y } = at ?? { x: 0.5, y: 0.5 };
        const old = this.#zoom;
        this.#zoom = Math.min(Math.max(zoom, Math.min(1, this.#actual)), Math.max(1, LARGEST * this.#actual));
        const move = (place: number, corner: number) => place - ((place - corner) * this.#zoom) / old;
        this.#corner = { x: move(x, this.#corner.x), y: move(y, this.#corner.y) };
        this.#show();
    }

    #pan(right: number, up: number): void {
        this.#corner = { x: this.#corner.x - right, y: this.#corner.y + up };
        this.#show();
    }

    /** Shows the picture. A large one fills the stage, and a small one is in its middle. */
    #show(): void {
        const rest = 1 - this.#zoom;
        const within = (corner: number) => (rest > 0 ? rest / 2 : Math.min(Math.max(corner, rest), 0));
        this.#corner = { x: within(this.#corner.x), y: within(this.#corner.y) };
        const { style } = this.stage;
        style.setProperty('--move', `${100 * this.#corner.x}%, ${100 * this.#corner.y}%`);
        style.setProperty('--zoom', String(this.#zoom));
        this.stage.classList.toggle('zoomed', this.#zoom > 1);
        this.#frame.hidden = this.#chosen === null;
        const { x, y } = this.#chosen ?? { x: 0, y: 0 };
        const percent = (part: number) => `${100 * part}%`;
        Object.assign(this.#frame.style, {
            left: percent(this.#corner.x + x * this.#zoom),
            top: percent(this.#corner.y + y * this.#zoom),
            width: percent(this.#zoom / this.#size.width),
            height: percent(this.#zoom / this.#size.height),
        });
        // A finger scrolls the page over a whole picture, and moves a zoomed one.
        style.touchAction = this.#zoom > 1 ? 'none' : 'pan-y';
        this.#scale.textContent = `${Math.round((100 * this.#zoom) / this.#actual)} %`;
        this.#tell();
        this.owner.moved?.();
    }

    #pixelAt({ x, y }: Place): [column: number, row: number] | null {
        const { width, height } = this.#canvases[0] ?? { width: 0, height: 0 };
        const [column, row] = [(x - this.#corner.x) / this.#zoom, (y - this.#corner.y) / this.#zoom];
        const isInside = column >= 0 && column < 1 && row >= 0 && row < 1;
        return isInside ? [Math.floor(column * width), Math.floor(row * height)] : null;
    }

    /** Writes the place and the bytes of the pixel that is told. A transparent pixel has no colour yet. */
    #tell(): void {
        const pixel = this.#told && this.#pixelAt(this.#told);
        const data = pixel ? this.#canvases.map((canvas) =>
            canvas.getContext('2d')?.getImageData(...pixel, 1, 1).data ?? new Uint8ClampedArray(4)) : [];
        // A large picture is shown in part, and its canvas has every `step`th pixel; a view's step may be a fraction.
        const step = Number(this.#canvases[0]?.dataset.step ?? 1);
        const colors = data.map((bytes) => bytes.slice(0, 3).join(' ')).join(' | ');
        const told = pixel && this.owner.told?.(...pixel);
        const isKnown = told || data.every((bytes) => bytes[3] !== 0);
        const places = pixel?.map((place) => Math.ceil(place * step)) ?? [];
        write(this.#pixel, () => (pixel && isKnown ? say('pixelAt', ...places, told ?? colors) : ''));
    }
}
