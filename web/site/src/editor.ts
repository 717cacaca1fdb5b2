// An editor for one of the two texts, with colours, completions and the renderer's faults.
import { isolateHistory } from '@codemirror/commands';
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { setDiagnostics } from '@codemirror/lint';
import { EditorState, Prec, Transaction } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { basicSetup } from 'codemirror';
import { completions } from './complete';
import type { Fault, Row } from './module';

/** What an editor tells the page. */
export interface Listener {
    changed(): void;
    render(): void;
}

const colours = HighlightStyle.define([
    { tag: tags.keyword, class: 'tag' },
    { tag: tags.number, class: 'number' },
    { tag: tags.name, class: 'name' },
]);

/** Returns the language of a text whose lines begin with the tags of `rows`. */
function language(rows: Row[]) {
    const known = new Set(rows.map((row) => row.tag));
    return StreamLanguage.define<{ isFirst: boolean }>({
        startState: () => ({ isFirst: true }),
        token(stream, state) {
            state.isFirst ||= stream.sol();
            if (stream.eatSpace()) {
                return null;
            }
            const word = stream.match(/\S+/) as RegExpMatchArray;
            const isTag = state.isFirst;
            state.isFirst = false;
            if (isTag) {
                return known.has(word[0]) ? 'keyword' : null;
            }
            return /^[-+.\d][-+.\deE]*$/.test(word[0]) ? 'number' : 'name';
        },
    });
}

/** Number of characters from which on inserted text goes to the editor directly. Otherwise the browser first puts it into
 * the page line by line, which takes minutes for some megabytes. */
const LONG_INPUT = 1000;

/** An editor of one text. */
export class Editor {
    readonly #view: EditorView;

    constructor(parent: HTMLElement, rows: Row[], label: HTMLElement, listener: Listener) {
        const source = completions(rows);
        const extensions = [
            Prec.highest(keymap.of([{ key: 'Mod-Enter', run: () => (listener.render(), true) }])),
            basicSetup,
            language(rows),
            syntaxHighlighting(colours),
            EditorState.languageData.of(() => [{ autocomplete: source }]),
            EditorView.contentAttributes.of({ 'aria-labelledby': label.id, spellcheck: 'false', autocapitalize: 'off' }),
            EditorView.domEventHandlers({
                beforeinput(event, view) {
                    const isLong = event.inputType === 'insertText' && (event.data?.length ?? 0) >= LONG_INPUT;
                    if (isLong) {
                        event.preventDefault();
                        view.dispatch(view.state.replaceSelection(event.data ?? ''), { userEvent: 'input.paste' });
                    }
                    return isLong;
                },
            }),
            EditorView.updateListener.of((update) => {
                if (update.docChanged) {
                    listener.changed();
                }
            }),
        ];
        this.#view = new EditorView({ parent, state: EditorState.create({ extensions }) });
    }

    get text(): string {
        return this.#view.state.doc.toString();
    }

    /** Replaces the whole text. The user can undo it. */
    set text(text: string) {
        this.#view.dispatch({
            changes: { from: 0, to: this.#view.state.doc.length, insert: text },
            selection: { anchor: 0 },
            annotations: [Transaction.userEvent.of('input.load'), isolateHistory.of('full')],
            scrollIntoView: true,
        });
    }

    /** Marks the fault in the text, or removes the mark. */
    mark(fault: Fault | null): void {
        const { state } = this.#view;
        const diagnostics = [];
        if (fault && fault.line > 0) {
            const [from, to] = this.#span(fault);
            diagnostics.push({ from, to, severity: 'error' as const, message: fault.message });
        }
        this.#view.dispatch(setDiagnostics(state, diagnostics));
    }

    /** Moves the cursor to the fault. */
    show(fault: Fault): void {
        const [anchor] = this.#span(fault);
        this.#view.dispatch({ selection: { anchor }, scrollIntoView: true });
        this.#view.focus();
    }

    /** Returns the offsets of the fault's first and last character. A missing word is marked behind the line. */
    #span(fault: Fault): [number, number] {
        const { doc } = this.#view.state;
        const line = doc.line(Math.min(Math.max(fault.line, 1), doc.lines));
        const from = Math.min(line.from + Math.max(fault.column, 1) - 1, line.to);
        return [from, Math.min(from + fault.length, line.to)];
    }
}
