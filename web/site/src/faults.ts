// Checks both texts with the renderer in a worker, marks the faults in the editors, and lists them below.
import type { Question, Verdict } from './checking';
import type { Editor } from './editor';
import type { Fault, TextNumber } from './module';
import { ofLanguage, say } from './words';

/** The checker of both texts. */
export class Checker {
    readonly #worker = new Worker('checking.js', { type: 'module' });
    /** The last text of each editor whose fault is known, and this fault. */
    readonly #known: ({ content: string; fault: Fault | null } | null)[] = [null, null];
    /** The functions that wait for the answers to questions. */
    readonly #waiting = new Map<number, (fault: Fault | null) => void>();
    #questions = 0;

    constructor(
        module: WebAssembly.Module,
        private readonly editors: [Editor, Editor],
        private readonly lists: [HTMLElement, HTMLElement],
    ) {
        this.#worker.onmessage = ({ data }: MessageEvent<Verdict>) => {
            this.#waiting.get(data.question)?.(data.fault);
            this.#waiting.delete(data.question);
        };
        this.#worker.onerror = ({ message }) => {
            this.#waiting.forEach((answer) => answer({ text: 2, line: 0, column: 0, length: 0, message }));
            this.#waiting.clear();
        };
        this.#ask({ module });
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
        const question = ++this.#questions;
        const fault = await new Promise<Fault | null>((answer) => {
            this.#waiting.set(question, answer);
            this.#ask({ question, text, content });
        });
        if (this.editors[text].text === content) {
            this.#known[text] = { content, fault };
            this.show(text, fault);
        }
        return fault && { ...fault, text };
    }

    #ask(question: Question): void {
        this.#worker.postMessage(question);
    }
}
