// The editor of the WGSL modules, with the faults of the compiler and the knobs of the text.
import { Editor } from './editor';
import { rowOf } from './faults';
import type { Edits, Module, ShaderFault } from './gpu/compose';
import { Knobs } from './knobs';
import * as store from './store';
import { element, messageOf, say, write } from './words';
import { wgsl } from './wgsl';

/** Time without typing after which the modules are compiled, in milliseconds. */
const PAUSE = 200;

/** The module that is shown first: its formula is short, and all of the picture shows it. */
const FIRST = 'background';

/** The modules that the user may edit: those of the picture and of the steps of a pixel. */
const ROOTS = ['kernels/image', 'kernels/steps'];

/** What the editor tells the page. */
export interface Listener {
    changed(edits: Edits): void;
    say(text: () => string): void;
}

/** The editor. */
export class ShaderEditor {
    readonly #select = element<HTMLSelectElement>('module');
    readonly #modules: Module[];
    readonly #editor: Editor;
    readonly #knobs: Knobs;
    #edits: Edits;
    #faults: ShaderFault[] = [];
    #isLoading = false;
    #timer = 0;

    constructor(modules: readonly Module[], private readonly listener: Listener) {
        const needed = new Set(ROOTS.flatMap((root) => modules.find((one) => one.name === root)?.needed ?? []));
        this.#modules = modules.filter((module) => needed.has(module.name));
        this.#edits = store.modules();
        this.#editor = new Editor(element('shader-editor'), wgsl, element('shader-label'), {
            changed: () => this.#typed(),
            // The modules are compiled after each pause, and the exact picture does not use them.
            render: () => undefined,
        });
        this.#knobs = new Knobs(element('knobs'), this.#editor);
        this.#fill();
        this.#select.addEventListener('change', () => this.#load());
        element('shader-reset').addEventListener('click', () => {
            this.#editor.text = this.#module?.source ?? '';
        });
        this.#choose();
        // The last words may have been typed less than a pause ago.
        addEventListener('pagehide', () => this.#keep());
    }

    /** The user's texts, by the names of their modules. */
    get edits(): Edits {
        return this.#edits;
    }

    /** Replaces the user's texts. */
    set edits(edits: Edits) {
        this.#edits = edits;
        this.#keep();
        this.#fill();
        this.#choose();
        this.listener.changed(edits);
    }

    /** Shows the faults of the compiler, or removes them. */
    show(faults: ShaderFault[]): void {
        this.#faults = faults;
        this.#mark();
        element('shader-faults').replaceChildren(...faults.slice(0, 5).map((fault) =>
            rowOf(fault, `${fault.module} `, () => this.#goTo(fault))));
        faults.length > 0 && this.#editor.reveal();
    }

    /** Shows the place of a fault in its module. */
    #goTo(fault: ShaderFault): void {
        if (this.#select.value !== fault.module) {
            this.#select.value = fault.module;
            this.#load();
        }
        this.#editor.show(fault);
    }

    get #module(): Module | undefined {
        return this.#modules.find((module) => module.name === this.#select.value);
    }

    /** Lists the modules. A star stands before those that the user has changed. */
    #fill(): void {
        const chosen = this.#select.value;
        const name = (module: Module) => `${module.name in this.#edits ? '* ' : ''}${module.name}`;
        this.#select.replaceChildren(...this.#modules.map((module) => new Option(name(module), module.name)));
        this.#select.value = chosen;
        const changed = Object.keys(this.#edits).join(', ');
        write(element('shader-changed'), () => (changed ? say('shadersChanged', changed) : ''));
    }

    /** Shows the first module that the user has changed, or else the one to begin with. */
    #choose(): void {
        this.#select.value = Object.keys(this.#edits)[0] ?? FIRST;
        if (!this.#module) {
            this.#select.value = FIRST;
        }
        this.#load();
    }

    #load(): void {
        const module = this.#module;
        this.#isLoading = true;
        this.#editor.begin(module ? this.#edits[module.name] ?? module.source : '');
        this.#isLoading = false;
        this.#knobs.show();
        this.#mark();
    }

    #mark(): void {
        this.#editor.mark(this.#faults.filter((fault) => fault.module === this.#select.value));
    }

    #typed(): void {
        const module = this.#module;
        if (this.#isLoading || !module) {
            return;
        }
        const { [module.name]: _, ...others } = this.#edits;
        const text = this.#editor.text;
        const wasChanged = module.name in this.#edits;
        this.#edits = text === module.source ? others : { ...others, [module.name]: text };
        if (wasChanged !== module.name in this.#edits) {
            this.#fill();
        }
        this.#knobs.show();
        clearTimeout(this.#timer);
        this.#timer = window.setTimeout(() => {
            this.#keep();
            this.listener.changed(this.#edits);
        }, PAUSE);
    }

    #keep(): void {
        try {
            store.keepModules(this.#edits);
        } catch (error) {
            this.listener.say(() => say('notKept', messageOf(error)));
        }
    }
}
