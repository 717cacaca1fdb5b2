// Checks both texts with the renderer, marks the faults in the editors, and lists them below.
import type { Editor } from './editor';
import { Renderer, type Fault, type TextNumber } from './module';
import { say } from './words';

/** The checker of both texts. */
export class Checker {
    #renderer: Renderer | null = null;

    constructor(
        private readonly module: WebAssembly.Module,
        private readonly editors: [Editor, Editor],
        private readonly lists: [HTMLElement, HTMLElement],
    ) {}

    /** Checks both texts, and returns their first fault or null. */
    async check(): Promise<Fault | null> {
        const faults: (Fault | null)[] = [];
        for (const text of [0, 1] as const) {
            const fault = await this.#fault(text);
            this.show(text, fault);
            faults.push(fault);
        }
        return faults[0] ?? faults[1] ?? null;
    }

    /** Marks a fault of a text and lists it, or removes the mark. */
    show(text: TextNumber, fault: Fault | null): void {
        this.editors[text].mark(fault);
        const list = this.lists[text];
        list.replaceChildren();
        if (!fault) {
            return;
        }
        const message = document.createElement('pre');
        message.textContent = fault.message;
        if (fault.line > 0) {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = say('line', fault.line);
            button.addEventListener('click', () => this.editors[text].show(fault));
            list.append(button);
        }
        list.append(message);
    }

    async #fault(text: TextNumber): Promise<Fault | null> {
        try {
            this.#renderer ??= await Renderer.create(this.module);
            this.#renderer.write(text, this.editors[text].text);
            return this.#renderer.check(text);
        } catch (error) {
            // The memory is exhausted. The next check begins with a new instance.
            this.#renderer = null;
            return { text, line: 0, column: 0, length: 0, message: String(error) };
        }
    }
}
