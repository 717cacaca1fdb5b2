// Mouse, touch and keyboard on a picture: drag, move, come closer, click.

/** A place in the picture, from 0 to 1 each way. */
export interface Place {
    x: number;
    y: number;
}

/** What the user wants. Moves are parts of the picture. A key has no place. */
export interface Wishes {
    drag(right: number, down: number, at: Place | null): void;
    pan(right: number, up: number): void;
    /** `factor` is below 1 to come closer. */
    zoom(factor: number, at: Place | null): void;
    reset(): void;
    /** The key Enter clicks the middle. */
    click(at: Place): void;
}

/** The moves of a key, with Shift and without. */
const [KEY_MOVE, KEY_DRAG] = [0.05, 1 / 36];

/** The factor of the distance for a key and for a step of a mouse wheel. */
const CLOSER = 0.9;

/** The distance of a step of a mouse wheel in pixels, and of two fingers on a trackpad, which a browser gives as Ctrl. */
const [WHEEL, PINCH] = [100, 10];

/** The distances of an event's units in pixels: pixels, lines and pages. */
const UNITS = [1, 33, 800];

/** Largest number of steps of one event. */
const MOST_STEPS = 3;

/** Largest distance in pixels between pressing and releasing for which the gesture is a click. */
const STILL = 4;

interface Pointer {
    x: number;
    y: number;
}

/** Listens to the gestures on an element. */
export class Gestures {
    readonly #pointers = new Map<number, Pointer>();
    #start: Pointer | null = null;
    /** The place of the gesture that has just ended, if it was a click. */
    #clicked: Place | null = null;

    constructor(private readonly element: HTMLElement, private readonly wishes: Wishes) {
        element.tabIndex = 0;
        element.style.touchAction = 'none';
        element.addEventListener('pointerdown', (event) => this.#down(event));
        element.addEventListener('pointermove', (event) => this.#move(event));
        element.addEventListener('pointerup', (event) => this.#up(event));
        // On a touch screen the browser sends this event last, to what is then under the finger. If `pointerup` had
        // already shown another view, that view would get it.
        element.addEventListener('click', () => {
            const place = this.#clicked;
            this.#clicked = null;
            place && wishes.click(place);
        });
        element.addEventListener('pointercancel', (event) => {
            this.#pointers.delete(event.pointerId);
            this.#start = null;
        });
        element.addEventListener('contextmenu', (event) => event.preventDefault());
        element.addEventListener('wheel', (event) => {
            event.preventDefault();
            const steps = (event.deltaY * (UNITS[event.deltaMode] ?? 1)) / (event.ctrlKey ? PINCH : WHEEL);
            wishes.zoom(CLOSER ** -Math.min(Math.max(steps, -MOST_STEPS), MOST_STEPS), this.placeOf(event));
        }, { passive: false });
        element.addEventListener('keydown', (event) => this.#key(event));
    }

    /** Returns where in the picture an event is. */
    placeOf(event: { clientX: number; clientY: number }): Place {
        const { left, top, width, height } = this.element.getBoundingClientRect();
        return { x: (event.clientX - left) / width, y: (event.clientY - top) / height };
    }

    #down(event: PointerEvent): void {
        this.element.focus();
        this.element.setPointerCapture(event.pointerId);
        this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        this.#clicked = null;
        this.#start = this.#pointers.size === 1 ? { x: event.clientX, y: event.clientY } : null;
    }

    #move(event: PointerEvent): void {
        const old = this.#pointers.get(event.pointerId);
        if (!old) {
            return;
        }
        const { width, height } = this.element.getBoundingClientRect();
        const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
        const now = { x: event.clientX, y: event.clientY };
        this.#pointers.set(event.pointerId, now);
        const [right, down] = [(now.x - old.x) / width, (now.y - old.y) / height];
        if (other) {
            // Two fingers: the distance between them zooms, and their middle moves by half of this finger's way.
            const distance = (one: Pointer) => Math.hypot(one.x - other.x, one.y - other.y) || 1;
            const middle = { clientX: (now.x + other.x) / 2, clientY: (now.y + other.y) / 2 };
            this.wishes.zoom(distance(old) / distance(now), this.placeOf(middle));
            this.wishes.pan(-right / 2, down / 2);
        } else if (event.shiftKey || (event.buttons & 2) !== 0) {
            this.wishes.pan(-right, down);
        } else if (right !== 0 || down !== 0) {
            this.wishes.drag(right, down, this.placeOf(event));
        }
    }

    #up(event: PointerEvent): void {
        this.#pointers.delete(event.pointerId);
        const start = this.#start;
        this.#start = null;
        const isStill = start && event.button === 0 && Math.hypot(event.clientX - start.x, event.clientY - start.y) < STILL;
        this.#clicked = isStill ? this.placeOf(event) : null;
    }

    #key(event: KeyboardEvent): void {
        const arrows: Record<string, [number, number]> = {
            ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
        };
        const arrow = arrows[event.key];
        if (event.ctrlKey || event.metaKey || event.altKey) {
            return;
        }
        if (arrow && event.shiftKey) {
            this.wishes.pan(arrow[0] * KEY_MOVE, arrow[1] * KEY_MOVE);
        } else if (arrow) {
            this.wishes.drag(-arrow[0] * KEY_DRAG, -arrow[1] * KEY_DRAG, null);
        } else if (event.key === '+' || event.key === '-') {
            this.wishes.zoom(event.key === '+' ? CLOSER : 1 / CLOSER, null);
        } else if (event.key === 'Home') {
            this.wishes.reset();
        } else if (event.key === 'Enter') {
            this.wishes.click({ x: 0.5, y: 0.5 });
        } else {
            return;
        }
        event.preventDefault();
    }
}
