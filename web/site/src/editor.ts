// An editor for one text, with colours, completions and marks for faults.
import { autocompletion } from '@codemirror/autocomplete';
import { isolateHistory } from '@codemirror/commands';
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { setDiagnostics } from '@codemirror/lint';
import { Compartment, EditorState, Prec, Transaction, type Extension } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { basicSetup } from 'codemirror';
import { completions } from './complete';
import type { Row } from './module';
import { editorWords } from './words';

/** What an editor tells the page. */
export interface Listener {
    changed(): void;
    render(): void;
}

/** A fault at its place in a text. */
export interface Mark {
    /** Counted from 1; 0 if the fault is not about a line. */
    line: number;
    /** Counted from 1, in units of UTF-16. */
    column: number;
    /** Length of the wrong word in units of UTF-16; 0 if a word is missing. */
    length: number;
    message: string;
}

const colours = HighlightStyle.define([
    { tag: tags.keyword, class: 'tag' },
    { tag: tags.number, class: 'number' },
    { tag: tags.name, class: 'name' },
    { tag: tags.comment, class: 'comment' },
]);

/** Returns the language of a text whose lines begin with the tags of `rows`, with completions. */
export function linesOf(rows: Row[]): Extension {
    const known = new Set(rows.map((row) => row.tag));
    const source = completions(rows);
    const language = StreamLanguage.define<{ isFirst: boolean }>({
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
    return [language, EditorState.languageData.of(() => [{ autocomplete: source }])];
}

/**
 * Number of characters from which on inserted text goes to the editor directly. Otherwise the browser first puts it
 * into the page line by line, which takes minutes for some megabytes.
 */
const LONG_INPUT = 1000;

/** An editor of one text. */
export class Editor {
    readonly #view: EditorView;

    constructor(parent: HTMLElement, language: Extension, label: HTMLElement, listener: Listener) {
        const words = new Compartment();
        const extensions = [
            words.of(EditorState.phrases.of(editorWords())),
            Prec.highest(keymap.of([{ key: 'Mod-Enter', run: () => (listener.render(), true) }])),
            basicSetup,
            // The icons are characters that the fonts of many systems lack.
            autocompletion({ icons: false }),
            language,
            syntaxHighlighting(colours),
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
        document.addEventListener('spoken', () =>
            this.#view.dispatch({ effects: words.reconfigure(EditorState.phrases.of(editorWords())) }));
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
        });
        // The page itself stays where it is: on a phone the picture is above the editors.
        this.#view.scrollDOM.scrollTop = 0;
    }

    /** Replaces a part of the text, as if the user had typed it. */
    replace(from: number, to: number, insert: string): void {
        this.#view.dispatch({ changes: { from, to, insert }, userEvent: 'input.type' });
    }

    /** Marks faults in the text, and removes the marks before. */
    mark(faults: readonly Mark[]): void {
        const diagnostics = faults.filter((fault) => fault.line > 0).map((fault) => {
            const [from, to] = this.#span(fault);
            return { from, to, severity: 'error' as const, message: fault.message };
        });
        this.#view.dispatch(setDiagnostics(this.#view.state, diagnostics));
    }

    /** Moves the cursor to the fault. */
    show(fault: Mark): void {
        const [anchor] = this.#span(fault);
        this.#view.dispatch({ selection: { anchor }, scrollIntoView: true });
        this.#view.focus();
    }

    /** Returns the offsets of the fault's first and last character. A missing word is marked behind the line. */
    #span(fault: Mark): [number, number] {
        const { doc } = this.#view.state;
        const line = doc.line(Math.min(Math.max(fault.line, 1), doc.lines));
        const from = Math.min(line.from + Math.max(fault.column, 1) - 1, line.to);
        return [from, Math.min(from + fault.length, line.to)];
    }
}
