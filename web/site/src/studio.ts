// The views that use the shaders. They are made when one of them is shown for the first time, so that a page without
// them starts sooner.
import { taken, type Camera } from './camera';
import { Device } from './gpu/device';
import type { Edits } from './gpu/compose';
import { Shaders } from './gpu/shaders';
import { Live } from './live';
import { keptEdits, ShaderEditor } from './shader-editor';
import type { Renderer } from './module';
import { Preparer } from './preparer';
import type { Texts } from './store';
import { Tabs } from './tabs';
import { say } from './words';

/** What the views need of the page. */
export interface Owner {
    texts(): Texts;
    replaceConfig(config: string): void;
    say(text: string): void;
    render(): void;
}

/** The parts that exist once a view of the shaders is shown. */
interface Parts {
    live: Live;
    shaders: Shaders | null;
}

/** The views of the shaders. */
export class Studio {
    readonly #tabs = new Tabs((name) => void this.#shown(name));
    #parts: Promise<Parts> | null = null;
    #editor: ShaderEditor | null = null;
    #isStale = true;

    constructor(
        private readonly module: WebAssembly.Module,
        private readonly renderer: Renderer,
        private readonly owner: Owner,
    ) {
        const part = document.getElementById('shader-part') as HTMLDetailsElement;
        part.addEventListener('toggle', () => part.open && this.#edit());
        part.open = Object.keys(keptEdits()).length > 0;
    }

    /** Takes the texts of the editors, which are valid. */
    changed(): void {
        this.#isStale = true;
        void this.#shown(this.#tabs.current);
    }

    async #shown(name: string): Promise<void> {
        const isExact = name === 'exact';
        if (isExact && !this.#parts) {
            return;
        }
        this.#parts ??= this.#make();
        const { live } = await this.#parts;
        if (!isExact && this.#isStale) {
            this.#isStale = false;
            const { config, scene } = this.owner.texts();
            await live.show(config, scene);
        }
        live.isShown = this.#tabs.current === 'live-pane';
    }

    /** Opens the editor of the shaders. */
    #edit(): ShaderEditor {
        this.#editor ??= new ShaderEditor(this.renderer.wgsl(), (edits) => void this.#edited(edits), () => this.owner.render());
        return this.#editor;
    }

    /** Compiles the user's modules. The exact picture does not use them, so the live view is shown. */
    async #edited(edits: Edits): Promise<void> {
        if (this.#tabs.current === 'exact') {
            this.#tabs.show('live-pane');
        }
        this.#parts ??= this.#make();
        const { live, shaders } = await this.#parts;
        if (shaders) {
            shaders.edits = edits;
            live.refresh();
        }
    }

    async #make(): Promise<Parts> {
        const device = await Device.open((reason) => this.owner.say(say('liveStopped', reason)));
        const shaders = device && new Shaders(device, this.renderer.wgsl());
        const live = new Live(new Preparer(this.module), device, shaders, {
            refused: (refused) => this.#editor?.show(refused?.faults ?? []),
            clicked: () => null,
            taken: (camera) => this.#take(camera),
        });
        if (shaders) {
            shaders.edits = keptEdits();
        }
        return { live, shaders };
    }

    #take(camera: Camera): void {
        this.owner.replaceConfig(taken(this.owner.texts().config, camera));
        this.owner.say(say('liveTaken'));
    }
}
