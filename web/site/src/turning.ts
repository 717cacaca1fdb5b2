// Changes the numbers of a line without typing: Alt and dragging changes one, and a square before a colour picks it.
import { isolateHistory } from '@codemirror/commands';
import type { Extension } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin, WidgetType, type DecorationSet } from '@codemirror/view';
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

/** Starts to change the number below the pointer, and returns true. Without Alt or a number, returns false. */
function turn(event: MouseEvent, view: EditorView, rows: Row[]): boolean {
    const at = event.altKey && event.button === 0 ? view.posAtCoords({ x: event.clientX, y: event.clientY }) : null;
    const line = view.state.doc.lineAt(at ?? 0);
    const numbers = line.text.matchAll(new RegExp(String.raw`(?<=\s)${NUMBER}(?!\S)`, 'g'));
    const [text, from] = Array.from(numbers, (match) => [match[0], line.from + match.index] as const)
        .find(([text, from]) => at !== null && from <= at && at <= from + text.length) ?? [];
    if (text === undefined || from === undefined) {
        return false;
    }
    const isWhole = rows.some(({ tag, values }) => line.text.trim().startsWith(tag) && values.includes('whole'));
    const size = Math.floor(Math.log10(Math.max(Math.abs(Number(text)), 1)));
    const digits = isWhole ? 0 : Math.max(2 - size, /\.(\d*)$/.exec(text)?.[1]?.length ?? 0, 0);
    const step = 10 ** Math.max(size - 2, -digits);
    let [to, isFirst] = [from + text.length, true];
    const move = ({ clientX }: MouseEvent) => {
        const value = Number(text) + step * Math.round((clientX - event.clientX) / PIXELS);
        const insert = (isWhole ? Math.max(value, 1) : value).toFixed(digits);
        replace(view, from, to, insert, isFirst);
        [to, isFirst] = [from + insert.length, false];
    };
    addEventListener('mousemove', move);
    addEventListener('mouseup', () => removeEventListener('mousemove', move), { once: true });
    return true;
}

/** Returns what changes numbers in a text whose lines `rows` describe. */
export const turning = (rows: Row[]): Extension =>
    [pickers, EditorView.domEventHandlers({ mousedown: (event, view) => turn(event, view, rows) })];
