// Checks both texts with the renderer in a worker, marks the faults in the editors, and lists them below.
import { Asked } from './asked';
import type { Verdict } from './checking';
import type { Editor } from './editor';
import type { Fault, TextNumber } from './module';
import { messageOf, ofLanguage, say } from './words';

/** The checker of both texts. */
export class Checker {
    readonly #worker: Asked<{ text: TextNumber; content: string }, Verdict>;
    /** The last text of each editor whose fault is known, and this fault. */
    readonly #known: ({ content: string; fault: Fault | null } | null)[] = [null, null];

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
        const faults = await Promise.all(texts.map((text) => this.#fault(text, this.editors[text].text)));
        return faults[0] ?? faults[1] ?? null;
    }

    /** Marks a fault of a text and lists it, or removes the mark. */
    show(text: TextNumber, fault: Fault | null): void {
        this.editors[text].mark(fault ? [fault] : []);
        const list = this.lists[text];
        list.replaceChildren();
        if (!fault) {
            return;
        }
        const message = document.createElement('pre');
        message.textContent = [fault.message, ofLanguage(fault.hints ?? ['', ''])].filter(Boolean).join('\n');
        if (fault.line > 0) {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = say('line', fault.line);
            button.addEventListener('click', () => this.editors[text].show(fault));
            list.append(button);
        }
        list.append(message);
    }

    /** Returns the fault of a text. A fault is shown only if the text is still in the editor. */
    async #fault(text: TextNumber, content: string): Promise<Fault | null> {
        const known = this.#known[text];
        if (known?.content === content) {
            this.show(text, known.fault);
            return known.fault;
        }
        const { fault } = await this.#worker.ask({ text, content }).catch((error: unknown) => (
            { fault: { text, line: 0, column: 0, length: 0, message: messageOf(error) } }));
        if (this.editors[text].text === content) {
            this.#known[text] = { content, fault };
            this.show(text, fault);
        }
        return fault;
    }
}
