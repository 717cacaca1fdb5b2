// Checks both texts with the renderer in a worker, marks the faults in the editors, and lists them below.
import { Asked } from './asked';
import type { Verdict } from './checking';
import type { Editor } from './editor';
import { MOST_FAULTS, textOf, type Fault, type TextNumber } from './module';
import { messageOf, say } from './words';

/** The checker of both texts. */
export class Checker {
    readonly #worker: Asked<{ text: TextNumber; content: string }, Verdict>;
    /** The last text of each editor whose faults are known, and these faults. */
    readonly #known: ({ content: string; faults: Fault[] } | null)[] = [null, null];

    constructor(
        module: WebAssembly.Module,
        private readonly editors: [Editor, Editor],
        private readonly lists: [HTMLElement, HTMLElement],
    ) {
        this.#worker = new Asked('checking.js', module);
    }

    /** Checks both texts, and returns their first fault or null. */
    async check(): Promise<Fault | null> {
        const texts = [0, 1] as const;
        const faults = await Promise.all(texts.map((text) => this.#faults(text, this.editors[text].text)));
        return faults.flat()[0] ?? null;
    }

    /** Marks the faults of a text and lists them, instead of those before. */
    show(text: TextNumber, faults: Fault[]): void {
        this.editors[text].mark(faults.map((fault) => ({ ...fault, message: textOf(fault) })));
        this.lists[text].replaceChildren(...faults.map((fault) => this.#row(text, fault)));
        if (faults.length === MOST_FAULTS) {
            this.lists[text].append(say('firstFaults', MOST_FAULTS));
        }
    }

    #row(text: TextNumber, fault: Fault): HTMLElement {
        const row = document.createElement('div');
        const message = document.createElement('pre');
        message.textContent = textOf(fault);
        if (fault.line > 0) {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = say('line', fault.line);
            button.addEventListener('click', () => this.editors[text].show(fault));
            row.append(button);
        }
        row.append(message);
        return row;
    }

    /** Returns the faults of a text. They are shown only if the text is still in the editor. */
    async #faults(text: TextNumber, content: string): Promise<Fault[]> {
        const known = this.#known[text];
        if (known?.content === content) {
            this.show(text, known.faults);
            return known.faults;
        }
        const { faults } = await this.#worker.ask({ text, content }).catch((error: unknown) => (
            { faults: [{ text, line: 0, column: 0, length: 0, message: messageOf(error) }] }));
        if (this.editors[text].text === content) {
            this.#known[text] = { content, faults };
            this.show(text, faults);
        }
        return faults;
    }
}
