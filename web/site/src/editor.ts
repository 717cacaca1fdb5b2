// An editor for one text, with colours, completions and marks for faults.
import { autocompletion } from '@codemirror/autocomplete';
import { invertedEffects, isolateHistory, redo, undo } from '@codemirror/commands';
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { setDiagnostics } from '@codemirror/lint';
import { Compartment, EditorState, Prec, StateEffect, Transaction, type Extension } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { basicSetup } from 'codemirror';
import { completions } from './complete';
import type { Row } from './module';
import { turning } from './turning';
import { editorWords } from './words';

/** What an editor tells the page. */
export interface Listener {
    changed(): void;
    render(): void;
    /** The user has undone, or done again, the change that has loaded a text with this number. */
    restored?(load: number, isUndone: boolean): void;
}

/** Marks a change that has loaded a text, with the number of the load. */
const loading = StateEffect.define<number>();

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
    return [language, turning(rows), EditorState.languageData.of(() => [{ autocomplete: source }])];
}

/**
 * Number of characters from which on inserted text goes to the editor directly. Otherwise the browser first puts it
 * into the page line by line, which takes minutes for some megabytes.
 */
const LONG_INPUT = 1000;

/** Time after a key for which a fault in its line is not shown, in milliseconds: the word may not be complete. */
export const TYPING = 1000;

/** An editor of one text. */
export class Editor {
    readonly #view: EditorView;
    readonly #extensions: Extension;
    readonly #words = new Compartment();
    /** When the text has changed last. */
    #typed = -Infinity;

    constructor(parent: HTMLElement, language: Extension, label: HTMLElement, listener: Listener) {
        this.#extensions = [
            this.#words.of(EditorState.phrases.of(editorWords())),
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
                    this.#typed = performance.now();
                    listener.changed();
                }
                const undone = update.transactions.find((one) => one.isUserEvent('undo') || one.isUserEvent('redo'));
                const load = undone?.effects.find((effect) => effect.is(loading));
                if (undone && load) {
                    listener.restored?.(load.value as number, undone.isUserEvent('undo'));
                }
            }),
            invertedEffects.of((change) => change.effects.filter((effect) => effect.is(loading))),
        ];
        this.#view = new EditorView({ parent, state: EditorState.create({ extensions: this.#extensions }) });
        document.addEventListener('spoken', () => this.#speak());
    }

    #speak(): void {
        this.#view.dispatch({ effects: this.#words.reconfigure(EditorState.phrases.of(editorWords())) });
    }

    get text(): string {
        return this.#view.state.doc.toString();
    }

    set text(text: string) {
        this.load(text, -1);
    }

    /** Starts with a text. The user can undo nothing. */
    begin(text: string): void {
        this.#view.setState(EditorState.create({ doc: text, extensions: this.#extensions }));
        this.#speak();
    }

    /** Undoes or redoes the last change. */
    restore(isUndone: boolean): void {
        (isUndone ? undo : redo)(this.#view);
    }

    /** Replaces the whole text, as load number `load` of the page. The user can undo it. */
    load(text: string, load: number): void {
        this.#view.dispatch({
            effects: loading.of(load),
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

    /** Whether the user has just typed in the line with this number. */
    isTyping(line: number): boolean {
        const { doc, selection } = this.#view.state;
        return performance.now() - this.#typed < TYPING && this.#view.hasFocus
            && doc.lineAt(selection.main.head).number === line;
    }

    /** Marks faults in the text, and removes the marks before. */
    mark(faults: readonly Mark[]): void {
        const diagnostics = faults.filter((fault) => fault.line > 0).map((fault) => {
            const [from, to] = this.#span(fault);
            return { from, to, severity: 'error' as const, message: fault.message };
        });
        this.#view.dispatch(setDiagnostics(this.#view.state, diagnostics));
    }

    /** Scrolls to the cursor if the user is in the editor, because something may have covered its line. */
    reveal(): void {
        if (this.#view.hasFocus) {
            this.#view.contentDOM.querySelector('.cm-activeLine')?.scrollIntoView({ block: 'nearest' });
        }
    }

    /** Moves the cursor to a line. */
    goTo(line: number): void {
        this.show({ line, column: 1, length: 0, message: '' });
    }

    /** Moves the cursor to the fault. */
    show(fault: Mark): void {
        const [anchor] = this.#span(fault);
        this.#view.dispatch({ selection: { anchor }, scrollIntoView: true });
        this.#view.focus();
        requestAnimationFrame(() => this.reveal());
    }

    /** Returns the offsets of the fault's first and last character. A missing word is marked behind the line. */
    #span(fault: Mark): [number, number] {
        const { doc } = this.#view.state;
        const line = doc.line(Math.min(Math.max(fault.line, 1), doc.lines));
        const from = Math.min(line.from + Math.max(fault.column, 1) - 1, line.to);
        return [from, Math.min(from + fault.length, line.to)];
    }
}
