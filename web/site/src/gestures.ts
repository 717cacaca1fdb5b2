// Mouse, touch and keyboard on a picture: turn, move, come closer, click.

/** What the user wants. Angles are in radians, moves are parts of the distance to the target. */
export interface Wishes {
    orbit(right: number, up: number): void;
    pan(right: number, up: number): void;
    zoom(factor: number): void;
    reset(): void;
    /** A click at a place of the picture, from 0 to 1 each way. */
    click(x: number, y: number): void;
}

/** The angle and the move for a drag over the whole picture, and for a key. */
const [DRAG_ANGLE, DRAG_MOVE, KEY_ANGLE, KEY_MOVE] = [Math.PI, 1, Math.PI / 36, 0.05];

/** The factor of the distance for a key and for a step of a mouse wheel. */
const CLOSER = 0.9;

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

    constructor(private readonly element: HTMLElement, private readonly wishes: Wishes) {
        element.tabIndex = 0;
        element.style.touchAction = 'none';
        element.addEventListener('pointerdown', (event) => this.#down(event));
        element.addEventListener('pointermove', (event) => this.#move(event));
        element.addEventListener('pointerup', (event) => this.#up(event));
        element.addEventListener('pointercancel', (event) => this.#pointers.delete(event.pointerId));
        element.addEventListener('contextmenu', (event) => event.preventDefault());
        element.addEventListener('wheel', (event) => {
            event.preventDefault();
            wishes.zoom(event.deltaY > 0 ? 1 / CLOSER : CLOSER);
        }, { passive: false });
        element.addEventListener('keydown', (event) => this.#key(event));
    }

    #down(event: PointerEvent): void {
        this.element.focus();
        this.element.setPointerCapture(event.pointerId);
        this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
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
            this.wishes.zoom(distance(old) / distance(now));
            this.wishes.pan((-right * DRAG_MOVE) / 2, (down * DRAG_MOVE) / 2);
        } else if (event.shiftKey || (event.buttons & 2) !== 0) {
            this.wishes.pan(-right * DRAG_MOVE, down * DRAG_MOVE);
        } else if (right !== 0 || down !== 0) {
            this.wishes.orbit(right * DRAG_ANGLE, down * DRAG_ANGLE);
        }
    }

    #up(event: PointerEvent): void {
        this.#pointers.delete(event.pointerId);
        const { left, top, width, height } = this.element.getBoundingClientRect();
        const start = this.#start;
        this.#start = null;
        if (start && Math.hypot(event.clientX - start.x, event.clientY - start.y) < STILL) {
            this.wishes.click((event.clientX - left) / width, (event.clientY - top) / height);
        }
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
            this.wishes.orbit(-arrow[0] * KEY_ANGLE, -arrow[1] * KEY_ANGLE);
        } else if (event.key === '+' || event.key === '-') {
            this.wishes.zoom(event.key === '+' ? CLOSER : 1 / CLOSER);
        } else if (event.key === 'Home') {
            this.wishes.reset();
        } else {
            return;
        }
        event.preventDefault();
    }
}
