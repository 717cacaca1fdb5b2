// Checks both texts with the renderer in a worker, marks the faults in the editors, and lists them below.
import { Asked } from './asked';
import { TYPING, type Editor, type Mark } from './editor';
import { faultOf, isFault, MOST_FAULTS, textOf, type Fault, type TextNumber } from './module';
import type { Answer, Request } from './preparing';
import { say, write } from './words';

/** Returns the row for a fault: its line, which `show` shows and whose text `module` begins, and its message. */
export function rowOf({ line, message }: Mark, module: string, show: () => void): HTMLElement {
    const [row, words] = [document.createElement('div'), document.createElement('pre')];
    words.textContent = message;
    if (line > 0) {
        const button = document.createElement('button');
        button.type = 'button';
        write(button, () => module + say('line', line));
        button.addEventListener('click', show);
        row.append(button);
    }
    row.append(words);
    return row;
}

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

    /** Whether the last check has found faults in a text that has not changed since. */
    isFaulty(text: TextNumber): boolean {
        const known = this.#known[text];
        return known !== null && known.content === this.editors[text].text && known.faults.length > 0;
    }

    /** Marks the faults of a text and lists them, instead of those before. */
    show(text: TextNumber, all: Fault[]): void {
        clearTimeout(this.#timers[text]);
        const faults = all.filter(({ line }) => !this.editors[text].isTyping(line));
        if (faults.length < all.length) {
            this.#timers[text] = window.setTimeout(() => this.show(text, all), TYPING);
        }
        this.editors[text].mark(faults.map((fault) => ({ ...fault, message: textOf(fault) })));
        this.lists[text].replaceChildren(...faults.map((fault) =>
            rowOf({ ...fault, message: textOf(fault) }, '', () => this.editors[text].show(fault))));
        if (faults.length === MOST_FAULTS) {
            this.lists[text].append(say('firstFaults', MOST_FAULTS));
        }
    }

    /** Returns the faults of a text. They are shown only if the text is still in the editor. */
    async #faults(text: TextNumber, content: string): Promise<Fault[]> {
        const known = this.#known[text];
        if (known?.content === content) {
            this.show(text, known.faults);
            return known.faults;
        }
        const request = { kind: 'check', text, content } as const;
        const answer = await this.#worker.ask({ request }).catch(faultOf);
        const faults = isFault(answer) ? [{ ...answer, text }] : JSON.parse(answer.facts) as Fault[];
        if (this.editors[text].text === content) {
            this.#known[text] = { content, faults };
            this.show(text, faults);
        }
        return faults;
    }
}
