// Changes the numbers of a line without typing: by Alt with dragging or an arrow key, or by a handle for fingers. A
// square before a colour picks it.
import { isolateHistory } from '@codemirror/commands';
import { Prec, type EditorState, type Extension } from '@codemirror/state';
import {
    Decoration, EditorView, keymap, showTooltip, ViewPlugin, WidgetType, type DecorationSet, type TooltipView,
} from '@codemirror/view';
import { hex, NUMBER } from './knobs';
import type { Row } from './module';
import { say } from './words';

/** A line with a colour: what stands before its numbers, and the three numbers. */
const COLOR = new RegExp(
    String.raw`^(\s*(?:(?:matte|metal):\s+\S+|background_\w+_color:)\s+)(${NUMBER})\s+(${NUMBER})\s+(${NUMBER})(?!\S)`);

/** The default gamma correction: the square has the colour that its light has in a picture. */
const GAMMA = 2.2;

/** Pixels of a drag for each step of the number. */
const PIXELS = 2;

/** Replaces a part of the text. The user can undo the change alone if it is the first one. */
function replace(view: EditorView, from: number, to: number, insert: string, isFirst: boolean): void {
    const annotations = isFirst ? isolateHistory.of('before') : [];
    view.dispatch({ changes: { from, to, insert }, userEvent: 'input.type', annotations });
}

/** The square. The editor leaves its events to the browser, and the keyboard skips it: a colour can be typed. */
class Square extends WidgetType {
    constructor(private readonly color: string) {
        super();
    }

    override eq(other: Square): boolean {
        return other.color === this.color;
    }

    override toDOM(view: EditorView): HTMLElement {
        const input = document.createElement('input');
        Object.assign(input, { type: 'color', className: 'square', value: this.color, tabIndex: -1, ariaLabel: say('color') });
        // What is picked at once is undone at once.
        let isFirst = true;
        input.addEventListener('change', () => (isFirst = true));
        input.addEventListener('input', () => {
            const { from, text } = view.state.doc.lineAt(view.posAtDOM(input));
            const [whole = '', start = ''] = COLOR.exec(text) ?? [];
            const light = (place: number) => (parseInt(input.value.slice(place, place + 2), 16) / 255) ** GAMMA;
            const insert = [1, 3, 5].map((place) => String(Number(light(place).toPrecision(3)))).join(' ');
            replace(view, from + start.length, from + whole.length, insert, isFirst);
            isFirst = false;
        });
        return input;
    }

    override updateDOM(input: HTMLElement): boolean {
        (input as HTMLInputElement).value = this.color;
        return true;
    }

    override ignoreEvent(): boolean {
        return true;
    }
}

/** Returns the squares of the lines that are in sight. */
function squares({ state: { doc }, visibleRanges }: EditorView): DecorationSet {
    const found = visibleRanges.flatMap(({ from, to }) => {
        const [first, last] = [doc.lineAt(from).number, doc.lineAt(to).number];
        return Array.from({ length: last - first + 1 }, (_, index) => doc.line(first + index)).flatMap((line) => {
            const [, start = '', ...channels] = COLOR.exec(line.text) ?? [];
            const color = `#${channels.map((channel) => hex(Math.max(Number(channel), 0) ** (1 / GAMMA))).join('')}`;
            const place = line.from + start.length;
            return start ? [Decoration.widget({ widget: new Square(color), side: -1 }).range(place)] : [];
        });
    });
    return Decoration.set(found, true);
}

const pickers = ViewPlugin.define((view) => ({
    squares: squares(view),
    update(update) {
        if (update.docChanged || update.viewportChanged) {
            this.squares = squares(update.view);
        }
    },
}), { decorations: (plugin) => plugin.squares });

/** A number of a line, its place in the text, and whether only whole numbers are allowed there. */
interface Place {
    text: string;
    from: number;
    isWhole: boolean;
}

/** Returns the number at the place `at`, or null. */
function numberAt({ doc }: EditorState, at: number, rows: Row[]): Place | null {
    const line = doc.lineAt(at);
    const isWhole = rows.some(({ tag, values }) => line.text.trim().startsWith(tag) && values.includes('whole'));
    const numbers = Array.from(line.text.matchAll(new RegExp(String.raw`(?<=\s)${NUMBER}(?!\S)`, 'g')), (match) =>
        ({ text: match[0], from: line.from + match.index, isWhole }));
    return numbers.find(({ text, from }) => from <= at && at <= from + text.length) ?? null;
}

/** Returns a number that is changed by some steps. A step is a hundredth of its order of magnitude. */
function turned({ text, isWhole }: Place, steps: number): string {
    const size = Math.floor(Math.log10(Math.max(Math.abs(Number(text)), 1)));
    const digits = isWhole ? 0 : Math.max(2 - size, /\.(\d*)$/.exec(text)?.[1]?.length ?? 0, 0);
    const value = Number(text) + 10 ** Math.max(size - 2, -digits) * steps;
    return (isWhole ? Math.max(value, 1) : value).toFixed(digits);
}

/** Changes the number at the place `at` while a pointer moves from `start` on. Returns false without a number. */
function drag(view: EditorView, at: number | null, start: number, rows: Row[]): boolean {
    const number = at === null ? null : numberAt(view.state, at, rows);
    if (!number) {
        return false;
    }
    let [to, isFirst] = [number.from + number.text.length, true];
    const move = ({ clientX }: PointerEvent) => {
        const insert = turned(number, Math.round((clientX - start) / PIXELS));
        replace(view, number.from, to, insert, isFirst);
        [to, isFirst] = [number.from + insert.length, false];
    };
    const end = new AbortController();
    addEventListener('pointermove', move, end);
    ['pointerup', 'pointercancel'].forEach((name) => addEventListener(name, () => end.abort(), end));
    return true;
}

/** Changes the number at the cursor by a step. Without one, another command gets the key. */
const step = (steps: number, rows: Row[]) => (view: EditorView): boolean => {
    const number = numberAt(view.state, view.state.selection.main.head, rows);
    number && replace(view, number.from, number.from + number.text.length, turned(number, steps), false);
    return number !== null;
};

/** Returns a handle above the number at the cursor, for fingers: a style sheet hides it from others. */
function handle(rows: Row[]): Extension {
    const create = (view: EditorView): TooltipView => {
        const dom = document.createElement('div');
        Object.assign(dom, { className: 'turn', textContent: '◂ ▸', ariaHidden: 'true' });
        dom.addEventListener('pointerdown', (event) => {
            event.preventDefault();
            drag(view, view.state.selection.main.head, event.clientX, rows);
        });
        return { dom };
    };
    return showTooltip.compute(['doc', 'selection'], (state) => {
        const { main } = state.selection;
        const number = main.empty ? numberAt(state, main.head, rows) : null;
        return number && { pos: number.from, above: true, create };
    });
}

/** Returns what changes numbers in a text whose lines `rows` describe. */
export const turning = (rows: Row[]): Extension => [
    pickers,
    handle(rows),
    Prec.high(keymap.of([{ key: 'Alt-ArrowUp', run: step(1, rows) }, { key: 'Alt-ArrowDown', run: step(-1, rows) }])),
    EditorView.domEventHandlers({
        mousedown: (event, view) => event.altKey && event.button === 0
            && drag(view, view.posAtCoords({ x: event.clientX, y: event.clientY }), event.clientX, rows),
    }),
];
