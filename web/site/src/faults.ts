// Checks both texts with the renderer in a worker, marks the faults in the editors, and lists them below.
import { Asked } from './asked';
import { TYPING, type Editor } from './editor';
import { MOST_FAULTS, textOf, type Fault, type TextNumber } from './module';
import type { Answer, Request } from './preparing';
import { messageOf, say } from './words';

/** The checker of both texts. */
export class Checker {
    readonly #worker: Asked<{ request: Request }, Answer>;
    readonly #timers = [0, 0];
    /** The last text of each editor whose faults are known, and these faults. */
    readonly #known: ({ content: string; faults: Fault[] } | null)[] = [null, null];

    constructor(
        module: WebAssembly.Module,
        private readonly editors: [Editor, Editor],
        private readonly lists: [HTMLElement, HTMLElement],
    ) {
        this.#worker = new Asked('preparing.js', module);
    }

    /** Checks both texts, and returns their first fault or null. */
    async check(): Promise<Fault | null> {
        const texts = [0, 1] as const;
        const faults = await Promise.all(texts.map((text) => this.#faults(text, this.editors[text].text)));
        return faults.flat()[0] ?? null;
    }

    /** Marks the faults of a text and lists them, instead of those before. */
    show(text: TextNumber, all: Fault[]): void {
        clearTimeout(this.#timers[text]);
        const faults = all.filter(({ line }) => !this.editors[text].isTyping(line));
        if (faults.length < all.length) {
            this.#timers[text] = window.setTimeout(() => this.show(text, all), TYPING);
        }
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
        const request = { kind: 'check', text, content } as const;
        const faults = await this.#worker.ask({ request }).then(({ fault, facts }) =>
            (fault ? [{ ...fault, text }] : JSON.parse(facts) as Fault[])).catch((error: unknown) =>
            [{ text, line: 0, column: 0, length: 0, message: messageOf(error) }]);
        if (this.editors[text].text === content) {
            this.#known[text] = { content, faults };
            this.show(text, faults);
        }
        return faults;
    }
}
