// The views that use the shaders. They are made when one of them is shown for the first time, so that a page without
// them starts sooner.
import { taken, type Camera } from './camera';
import { Comparison } from './compare';
import { onFiles } from './files';
import { Device, Unavailable, type Refused } from './gpu/device';
import type { Edits } from './gpu/compose';
import { Shaders } from './gpu/shaders';
import { Live } from './live';
import type { View } from './link';
import { ShaderEditor } from './shader-editor';
import * as store from './store';
import type { Renderer } from './module';
import { PixelView, type Source } from './pixel';
import type { Picture } from './picture';
import { Preparer } from './preparer';
import type { Texts } from './store';
import { Tabs } from './tabs';
import { element, messageOf, say, write } from './words';
import type { ExplainView } from './explain';

/** What the views need of the page. */
export interface Owner {
    /** The texts that the views show: the last ones without an error. */
    texts(): Texts;
    /** Changes the configuration in the editor, and saves it if this is wanted. Returns false if that failed. */
    changeConfig(change: (config: string) => string, isSaved: boolean): Promise<boolean>;
    say(text: () => string): void;
    /** Shows a line of the scene in its editor. */
    goTo(line: number): void;
    /** Another view is about to be shown. */
    left(): void;
    /** Removes the last message, because the shaders have changed. */
    unsay(): void;
}

/** The parts that exist once a view of the shaders is shown. */
interface Parts {
    live: Live;
    comparison: Comparison;
    pixel: PixelView;
    /** The shaders of the live view and of the comparison; none without WebGPU. */
    shaders: Shaders[];
}

/** The views of the shaders. */
export class Studio {
    readonly #tabs: Tabs;
    #parts: Promise<Parts> | null = null;
    #made: Parts | null = null;
    #explain: ExplainView | null = null;
    /** Counts the views of links. */
    #views = 0;
    #device: Device | null = null;
    readonly #part = element<HTMLDetailsElement>('shader-part');
    #editor: ShaderEditor | null = null;
    #reading = Promise.resolve();
    /** The views that have not seen the last texts. */
    #stale = new Set(['live-pane', 'compare-pane']);

    constructor(
        private readonly module: WebAssembly.Module,
        private readonly renderer: Renderer,
        private readonly picture: Picture,
        private readonly owner: Owner,
    ) {
        this.#tabs = new Tabs((name) => void this.#shown(name), () => owner.left());
        this.#part.addEventListener('toggle', () => this.#part.open && this.#edit());
        this.#part.open = Object.keys(store.modules()).length > 0;
        element('gpu-again').addEventListener('click', () => void this.#again());
        const files = element<HTMLInputElement>('files');
        onFiles(element('compare-files'), files, 'pictures', (chosen) => void this.#compare(chosen));
    }

    /** Takes the texts of the editors, which are valid. */
    changed(): void {
        this.#stale = new Set(['live-pane', 'compare-pane']);
        void this.#parts?.then(({ pixel }) => pixel.forget());
        void this.#shown(this.#tabs.current);
    }

    /** Removes all pictures, because another scene is loaded. */
    clear(): void {
        void this.#parts?.then(({ live, comparison }) => [live, comparison].forEach((one) => one.clear()));
    }

    /** Replaces the user's modules. */
    set modules(modules: Edits) {
        if (this.#editor || Object.keys(modules).length > 0 || Object.keys(store.modules()).length > 0) {
            this.#edit().edits = modules;
        }
        this.#part.open ||= Object.keys(modules).length > 0;
    }

    /** Returns what is shown, for a link and for the browser's history. */
    get view(): View {
        const [parts, tab] = [this.#made, this.#tabs.current];
        const places = { 'pixel-pane': parts?.pixel.place, 'explain-pane': this.#explain?.place } as Record<string, [number, number]>;
        return { tab, camera: parts?.live.moved ?? null, pixel: places[tab] ?? null };
    }

    /** Shows a view of a link, or of an earlier entry of the browser's history. */
    async show({ tab, camera, pixel }: View): Promise<void> {
        const own = ++this.#views;
        if (tab === 'explain-pane' && pixel) {
            (await this.#explained()).place = pixel;
        } else if (tab !== 'exact' || camera || this.#parts) {
            this.#parts ??= this.#make();
            const { live, pixel: path } = await this.#parts;
            await this.#read(live);
            if (own !== this.#views) {
                return;
            }
            live.moved = camera;
            if (pixel && await this.#settles(live) && live.source) {
                await path.show(live.source, ...pixel);
            }
        }
        this.#tabs.show(tab, true);
    }

    /** Makes the moved camera of the live view count. If that camera is impossible, says so and returns false. */
    async #settles(live: Live): Promise<boolean> {
        try {
            await live.settle();
            return true;
        } catch (error) {
            this.owner.say(() => say('liveStopped', messageOf(error)));
            return false;
        }
    }

    /** Gives the texts to the live view, if it has not seen them. */
    #read(live: Live): Promise<void> {
        if (this.#stale.delete('live-pane')) {
            const { config, scene } = this.owner.texts();
            this.#reading = live.show(config, scene);
        }
        return this.#reading;
    }

    /** Returns the view that explains a pixel. Its code is loaded when it is needed. */
    async #explained(): Promise<ExplainView> {
        const { ExplainView } = await import('./explain');
        return this.#explain ??= new ExplainView(() => this.picture.explained, (line) => this.owner.goTo(line),
            (...pixel) => this.#made?.comparison.beside(...pixel) ?? null);
    }

    async #shown(name: string): Promise<void> {
        if (name === 'explain-pane') {
            this.#made && (this.#made.live.isShown = false);
            await (await this.#explained()).renew();
            return;
        }
        if (name === 'exact' && !this.#parts) {
            return;
        }
        this.#parts ??= this.#make();
        const { live, comparison, pixel } = await this.#parts;
        if (name === 'live-pane') {
            await this.#read(live);
        }
        live.isShown = this.#tabs.current === 'live-pane';
        if (name === 'compare-pane' && this.#stale.delete(name)) {
            await comparison.show(this.owner.texts());
        }
        if (name === 'pixel-pane') {
            await pixel.renew(this.picture.explained);
        }
    }

    /** Compares two files, or one with the exact picture. */
    async #compare(files: File[]): Promise<void> {
        this.#tabs.show('compare-pane');
        this.#parts ??= this.#make();
        const { comparison } = await this.#parts;
        await comparison.showFiles(files, this.picture.pixels);
        this.reveal('compare-pane');
    }

    /** Takes a new exact picture, with which a file may be compared. */
    async rendered(): Promise<void> {
        if (this.#tabs.current === 'explain-pane') {
            await this.#explain?.renew();
        }
        await (await this.#parts)?.comparison.renew(this.picture.pixels);
    }

    /** Shows a view, and scrolls to its start: on a phone the page may be scrolled below it. */
    reveal(name: string): void {
        this.#tabs.show(name);
        document.querySelector('.tabs')!.scrollIntoView({ block: 'nearest' });
    }

    /** Opens the editor of the shaders. */
    #edit(): ShaderEditor {
        this.#editor ??= new ShaderEditor(this.renderer.wgsl(), {
            changed: (edits) => void this.#edited(edits),
            say: (text) => this.owner.say(text),
        });
        return this.#editor;
    }

    /** Compiles the user's modules. The exact picture does not use them, so the live view is shown. */
    async #edited(edits: Edits): Promise<void> {
        this.owner.unsay();
        if (this.#tabs.current === 'exact') {
            this.#tabs.show('live-pane');
        }
        this.#parts ??= this.#make();
        const { live, comparison, pixel, shaders } = await this.#parts;
        shaders.forEach((one) => (one.edits = edits));
        live.refresh();
        if (this.#tabs.current === 'compare-pane') {
            void comparison.refresh();
        } else {
            this.#stale.add('compare-pane');
        }
        if (this.#tabs.current === 'pixel-pane' && pixel.place) {
            void pixel.refresh();
        }
    }

    async #make(): Promise<Parts> {
        const refused = (fault: Refused | null) => this.#editor?.show(fault?.faults ?? []);
        const broken = (error: unknown) => void this.#broken(error);
        const pixel = new PixelView(this.renderer.stepNames(), async () => {
            await this.#read(live);
            return await this.#settles(live) ? live.source : null;
        }, refused, broken, (line) => this.owner.goTo(line));
        const follow = (source: Source | null | undefined, column: number, row: number) => {
            if (source) {
                this.reveal('pixel-pane');
                void pixel.show(source, column, row);
            }
        };
        const live: Live = new Live(new Preparer(this.module), {
            refused,
            broken,
            clicked: async (x, y) => {
                if (await this.#settles(live) && live.source) {
                    const { width, height } = live.source.facts;
                    follow(live.source, Math.floor(x * width), Math.floor(y * height));
                }
            },
            taken: (camera, isSaved) => void this.#take(camera, isSaved),
        });
        const comparison: Comparison = new Comparison(new Preparer(this.module), {
            refused,
            broken,
            clicked: (column, row) => follow(comparison.source, column, row),
            chosen: (column, row) => this.picture.choose(column, row),
            closed: () => {
                this.#stale.add('compare-pane');
                void this.#shown(this.#tabs.current);
            },
        });
        const parts: Parts = { live, comparison, pixel, shaders: [] };
        await this.#connect(parts);
        this.#made = parts;
        return parts;
    }

    /** Opens WebGPU for the views. */
    async #connect(parts: Parts): Promise<void> {
        write(element('live-status'), () => say('gpuOpening'));
        const device = await Device.open().catch(Unavailable.of);
        this.#use(parts, device);
        if (device instanceof Device) {
            void device.failed.then((failure) => {
                if (this.#device === device) {
                    void this.#broken(failure);
                }
            });
        }
    }

    /** Goes on without WebGPU, which has failed. */
    async #broken(error: unknown): Promise<void> {
        const parts = await this.#parts;
        if (parts && this.#device) {
            this.#use(parts, Unavailable.of(error));
            this.changed();
        }
    }

    /** Tries to open WebGPU again. */
    async #again(): Promise<void> {
        const parts = await this.#parts;
        if (parts) {
            const button = element<HTMLButtonElement>('gpu-again');
            button.disabled = true;
            await this.#connect(parts);
            button.disabled = false;
            this.changed();
        }
    }

    /** Gives shaders on this device to the views. Without a device the exact renderer draws, and a line says why. */
    #use(parts: Parts, device: Device | Unavailable): void {
        this.#device = device instanceof Device ? device : null;
        const modules = this.renderer.wgsl();
        parts.shaders = device instanceof Device ? [new Shaders(device, modules), new Shaders(device, modules)] : [];
        parts.shaders.forEach((one) => (one.edits = this.#editor?.edits ?? store.modules()));
        parts.live.shaders = parts.shaders[0] ?? null;
        parts.comparison.shaders = parts.shaders[1] ?? null;
        this.#editor?.show([]);
        element('live-none').hidden = device instanceof Device;
        if (device instanceof Unavailable) {
            write(element('gpu-cause'), () => say(device.key, device.detail));
        }
    }

    /** Writes the camera into the configuration, and saves it in its file if this is wanted. */
    async #take(camera: Camera, isSaved: boolean): Promise<void> {
        if (await this.owner.changeConfig((config) => taken(config, camera), isSaved)) {
            this.owner.say(() => say(isSaved ? 'liveSaved' : 'liveTaken'));
        }
    }
}
