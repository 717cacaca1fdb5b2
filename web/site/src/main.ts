// Connects the parts of the page.
import { movable } from './bars';
import { Editor, linesOf } from './editor';
import * as entries from './entries';
import type { Entry } from './entries';
import { example, FIRST, names } from './examples';
import { Checker } from './faults';
import { onFiles } from './files';
import * as link from './link';
import { Saving } from './saving';
import { takeSecret } from './secret';
import { Studio } from './studio';
import { causeOf, compile, instructionSet, Renderer, type Fault, type Row } from './module';
import { Picture } from './picture';
import * as store from './store';
import { isSame, type Current, type Texts } from './store';
import * as view from './view';
import { dated, element, type Language, messageOf, say, speak, write } from './words';

/** Time without typing after which the texts are checked, in milliseconds. */
const PAUSE = 200;

/** Largest size of a text file that is opened, in bytes, as `render-lab view` has it. */
const MOST_TEXT = 16 << 20;

/** Number of characters from which on a link may be cut by programs that pass it on. */
const LONG_LINK = 8000;

const languages = element<HTMLSelectElement>('language');
const earlierTexts = element<HTMLSelectElement>('earlier');
const examples = element<HTMLSelectElement>('examples');
const live = element<HTMLInputElement>('live');

/** How texts are loaded. */
interface Loading {
    isTyped?: boolean;
    isLink?: boolean;
    losesTyped?: boolean;
    name?: string | undefined;
}

/** The parts that exist once the module is loaded. */
class Page {
    #isTyped = false;
    #isLink = false;
    #isLoading = false;
    /** The name of the scene that was loaded last, if it is not that of a file of `render-lab view`. */
    #name: string | undefined;
    /** The texts before and after each load, for undoing it in both editors. */
    readonly #loads: [before: Texts, after: Texts][] = [];
    /** The texts that the views show: the last ones without an error. */
    #shown: Texts = { config: '', scene: '' };
    #timer = 0;
    readonly #editors: [Editor, Editor];
    readonly #checker: Checker;
    readonly #studio: Studio;
    readonly #picture = new Picture((fault) => {
        if (fault.text < 2) {
            this.#checker.show(fault.text as 0 | 1, [fault]);
        }
        this.#picture.say(() => (fault.text < 2 ? this.#faultIn(fault.text) : say('failed', causeOf(fault))));
    }, () => void this.#studio.rendered(), () => this.#ownName ?? this.#saving.name ?? 'picture', () => this.module, (line) => this.#editors[1].goTo(line));
    readonly #saving: Saving;

    constructor(private readonly module: WebAssembly.Module, renderer: Renderer) {
        const tables = [renderer.table(0), renderer.table(1)] as const;
        const listener = {
            changed: () => this.#changed(),
            render: () => this.#ask(),
            restored: (load: number, isUndone: boolean) => this.#restored(load, isUndone),
        };
        const editor = (name: string, rows: Row[]) =>
            new Editor(element(`${name}-editor`), linesOf(rows), element(`${name}-label`), listener);
        this.#editors = [editor('config', tables[0]), editor('scene', tables[1])];
        this.#saving = new Saving(this.#editors, {
            load: ([config, scene], isLost) => {
                this.load({ config, scene }, { losesTyped: isLost });
                void this.render();
            },
            keep: () => this.#keep(),
            say: (text) => this.say(text),
        });
        this.#checker = new Checker(module, this.#editors, [element('config-faults'), element('scene-faults')]);
        this.#studio = new Studio(module, renderer, this.#picture, {
            texts: () => this.#shown,
            changeConfig: async (change, isSaved) => {
                this.#editors[0].text = change(this.#texts.config);
                return !isSaved || this.#saving.save(0);
            },
            say: (text) => this.say(text),
            goTo: (line) => this.#editors[1].goTo(line),
            left: () => this.leave(false),
            unsay: () => this.#unsay(),
        });
        addEventListener('pagehide', () => this.#keep());
        document.addEventListener('keydown', (event) => {
            if (event.key === 'Enter' && (event.ctrlKey || event.metaKey) && !event.defaultPrevented) {
                event.preventDefault();
                this.#ask();
            }
        });
        document.querySelectorAll<HTMLElement>('.bar').forEach(movable);
        document.querySelectorAll<HTMLElement>('.fold').forEach((button) => button.addEventListener('click', () => {
            const isFolded = element(button.dataset.editor ?? '').classList.toggle('folded');
            button.ariaExpanded = String(!isFolded);
        }));
        element('full').addEventListener('click', () => void (document.fullscreenElement
            ? document.exitFullscreen() : element('result').requestFullscreen()));
        element('render').addEventListener('click', () => this.#ask());
        element('share').addEventListener('click', () => void this.#share());
        onFiles(element('open'), element<HTMLInputElement>('texts-files'), 'texts', (files) => void this.#open(files, tables));
    }

    /** The name of the scene, unless no line is left of the one that was loaded. */
    get #ownName(): string | undefined {
        const lines = (text = '') => text.split('\n').map((line) => line.trim()).filter(Boolean);
        const loaded = this.#name ? new Set(lines(this.#loads.at(-1)?.[1].scene)) : null;
        return loaded && lines(this.#texts.scene).some((line) => loaded.has(line)) ? this.#name : undefined;
    }

    get #texts(): Texts {
        return { config: this.#editors[0].text, scene: this.#editors[1].text };
    }

    /**
     * Shows a message below the picture, and below the view that is shown instead of the picture. If `stays` holds, the
     * end of a picture does not replace it.
     */
    say(text: () => string, stays = false): void {
        this.#picture.note(text, stays);
        write(element('said'), text);
    }

    /** Removes the last message and link, which were about texts or shaders that have changed since. */
    #unsay(): void {
        this.#picture.note(null);
        write(element('said'), () => '');
        element('link-line').hidden = true;
    }

    /**
     * Checks both texts. If they have no error, the views show them. Otherwise a sentence says that the views show
     * earlier texts. Another one says so for the exact picture, which waits for the user.
     */
    async #check(): Promise<Fault | null> {
        const texts = this.#texts;
        const fault = await this.#checker.check();
        if (isSame(texts, this.#texts)) {
            if (!fault && !isSame(texts, this.#shown)) {
                this.#shown = texts;
                this.#studio.changed();
            }
            this.#mark(fault);
        }
        return fault;
    }

    /**
     * Marks the picture if it does not belong to the texts, and all views if the texts have an error. Without a
     * picture, nothing belongs to earlier texts.
     */
    #mark(fault: Fault | null): void {
        const isOld = !this.#picture.isOf(this.#texts);
        element('result').dataset.old = fault ? 'all' : isOld ? 'exact' : 'none';
        const words = () => (isOld ? say('oldPicture') : '');
        const views = () => (this.#picture.isNone ? '' : ` ${say('oldViews')}`);
        write(element('old'), () => (fault ? this.#faultIn(fault.text) + views() : words()));
    }

    /** Reads the files of `render-lab view`, and returns the texts to show. */
    async openFiles(kept: Current | null): Promise<Texts> {
        const [config, scene] = await this.#saving.open(kept);
        return { config, scene };
    }

    /** What the page shows, for the browser's history. */
    get entry(): Entry {
        const [modules, isTyped, isLink, name] = [store.modules(), this.#isTyped, this.#isLink, this.#ownName];
        const { unsaved } = this.#saving.kept;
        return { ...this.#texts, modules, isTyped, isLink, unsaved, view: this.#studio.view, ...(name ? { name } : {}) };
    }

    /** Whether the user has typed something that is not saved. */
    get isUnsaved(): boolean {
        return this.#isTyped && this.#saving.isAnyUnsaved;
    }

    /** Begins a new entry of the browser's history, with other texts if `isLoad` holds. */
    leave(isLoad: boolean): void {
        entries.keep(this.entry);
        entries.push(isLoad);
    }

    /** Shows what the browser's entry has shown, after Back or Forward. */
    move(): void {
        if (entries.bounces(this.isUnsaved)) {
            this.say(() => (this.isUnsaved ? say('unsavedBack') : ''), this.isUnsaved);
        } else if (entries.hasChanged()) {
            entries.keep(this.entry);
            const entry = entries.shown();
            if (entry?.view && entries.hasSameTexts()) {
                entries.begin();
                void this.#studio.show(entry.view);
            } else if (entry) {
                void this.open(entry);
            }
        }
    }

    /** Undoes a load in both editors, or does it again, after the user has done so in one of them. */
    #restored(load: number, isUndone: boolean): void {
        const texts = this.#loads[load]?.[isUndone ? 0 : 1];
        for (const [number, name] of (['config', 'scene'] as const).entries()) {
            const editor = this.#editors[number];
            if (texts && editor && editor.text !== texts[name]) {
                editor.restore(isUndone);
                if (editor.text !== texts[name]) {
                    editor.text = texts[name];
                }
            }
        }
    }

    /** Opens the text files that the user has chosen or dropped. Their names or their lines tell what they are. */
    async #open(files: File[], tables: readonly Row[][]): Promise<void> {
        const texts = { ...this.#texts };
        let name = this.#ownName;
        for (const file of files.slice(0, 2)) {
            if (file.size > MOST_TEXT) {
                this.say(() => say('textTooLarge', file.name));
                return;
            }
            const content = await file.text();
            const words = new Set(content.split('\n').map((line) => line.trim().split(/\s/, 1)[0]));
            const [asConfig = 0, asScene = 0] = tables.map((rows) => rows.filter(({ tag }) => words.has(tag)).length);
            const isConfig = /config/i.test(file.name) || (!/scene|escena/i.test(file.name) && asConfig > asScene);
            texts[isConfig ? 'config' : 'scene'] = content;
            name = isConfig ? name : file.name.replace(/\.[^.]*$/, '');
        }
        this.leave(true);
        this.clear();
        this.load(texts, { name });
        this.#ask();
    }

    /**
     * Replaces both texts. What the user had typed becomes one of the earlier texts. `losesTyped` is false if what was
     * typed stays in the new texts.
     */
    load(texts: Texts & Pick<Current, 'unsaved'>, { isTyped = false, isLink = false, losesTyped = this.#isTyped, name }: Loading = {}): void {
        // What follows may say that the browser keeps no texts.
        this.#unsay();
        const own = store.modules();
        const losesModules = texts.modules !== undefined && Object.keys(own).length > 0
            && JSON.stringify(own) !== JSON.stringify(texts.modules);
        if (losesTyped || losesModules) {
            this.keepEarlier(this.#texts);
        }
        const load = this.#loads.push([this.#texts, texts]) - 1;
        this.#isLoading = true;
        for (const [number, name] of (['config', 'scene'] as const).entries()) {
            const editor = this.#editors[number];
            load === 0 ? editor?.begin(texts[name]) : editor?.load(texts[name], load);
        }
        this.#isLoading = false;
        this.#name = name;
        this.#saving.loaded(texts.unsaved);
        [this.#isTyped, this.#isLink] = [isTyped || (view.isServed && this.#saving.isAnyUnsaved), isLink];
        this.#keep();
        this.showEarlier();
        this.#shown = this.#texts;
        this.#studio.changed();
        if (texts.modules) {
            this.#studio.modules = texts.modules;
        }
    }

    /** Removes all pictures, because texts of another origin are loaded. */
    clear(): void {
        this.#picture.clear();
        this.#studio.clear();
    }

    /** Shows and renders what a link or an entry of the browser's history has. */
    async open({ view: shown, isTyped, isLink, name, ...texts }: Entry): Promise<void> {
        this.clear();
        this.load(texts, { isTyped, isLink, name });
        entries.begin();
        if (shown) {
            void this.#studio.show(shown);
        }
        await this.render();
    }

    /** Keeps texts that are about to be replaced as earlier texts. */
    keepEarlier(texts: Texts): void {
        this.#tryTo(() => store.keepEarlier({ ...texts, modules: store.modules() }));
    }

    /** Checks both texts, and renders them if they are valid. */
    async render(): Promise<void> {
        const fault = await this.#check();
        this.#keep();
        if (fault && this.#picture.isNone) {
            // The mark has named the error.
            this.#unsay();
        } else if (fault) {
            this.say(() => this.#faultIn(fault.text));
        } else {
            this.#picture.render(this.module, this.#texts);
            this.#mark(null);
        }
    }

    /** Renders because the user asks for it, and brings the picture into sight. */
    #ask(): void {
        this.#unsay();
        this.#studio.reveal('exact');
        void this.render();
    }

    showFaults(): void {
        void this.#check();
    }

    /** Lists the earlier texts. */
    showEarlier(): void {
        const all = store.earlier();
        const options = all.map((one, index) => new Option(
            `${dated(one.time)}: ${say('objects', ...store.sizes(one))}`, String(index)));
        earlierTexts.replaceChildren(new Option(say('choose'), ''), ...options);
        earlierTexts.disabled = all.length === 0;
    }

    /** Says which texts have errors: `text`, and the other one if it has errors too. */
    #faultIn(text: number): string {
        const faulty = ([0, 1] as const).filter((one) => one === text || this.#checker.isFaulty(one));
        return say('faultIn', faulty.map((one) => say(one === 0 ? 'config' : 'scene')).join(', '));
    }

    #changed(): void {
        if (this.#isLoading) {
            return;
        }
        this.#isTyped = true;
        entries.guard();
        this.#unsay();
        clearTimeout(this.#timer);
        this.#timer = window.setTimeout(() => void this.#settle(), PAUSE);
    }

    async #settle(): Promise<void> {
        this.#keep();
        this.#saving.mark();
        const fault = await this.#check();
        if (live.checked && !fault) {
            void this.render();
        }
    }

    #keep(): void {
        this.#tryTo(() => {
            const name = this.#ownName;
            store.keep({ ...this.#texts, isTyped: this.#isTyped, ...(name ? { name } : {}), ...this.#saving.kept });
        });
    }

    /** Calls `act`. If it fails, tells so. */
    #tryTo(act: () => void): void {
        try {
            act();
        } catch (error) {
            this.say(() => say('notKept', messageOf(error)));
        }
    }

    async #share(): Promise<void> {
        const text = await link.make({ ...this.#texts, modules: store.modules(), view: this.#studio.view });
        const field = element<HTMLInputElement>('link');
        field.value = text;
        element('link-line').hidden = false;
        field.scrollIntoView({ block: 'nearest' });
        // The clipboard is missing where the page is not from a trusted origin.
        const isCopied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
        field.select();
        this.say(() => say(isCopied ? 'copied' : 'made')
            + (text.length > LONG_LINK ? ` ${say('tooLong', text.length)}` : ''));
    }
}

/** Returns what the page shows at its start. */
async function first(page: Page): Promise<Entry> {
    const kept = store.current();
    const replaceBy = (entry: Partial<Entry> & Texts): Entry => {
        if (kept?.isTyped && !isSame(kept, entry)) {
            page.keepEarlier(kept);
        }
        return { isTyped: false, isLink: false, view: null, ...entry };
    };
    if (link.isLink(location.hash)) {
        try {
            return replaceBy({ ...await link.read(location.hash), isLink: true });
        } catch {
            page.say(() => say('badLink'));
        }
    }
    if (view.isServed) {
        return replaceBy(await page.openFiles(kept));
    }
    return replaceBy(entries.shown() ?? kept ?? { ...await example(FIRST), name: FIRST });
}

async function start(): Promise<void> {
    if (view.isServed && takeSecret()) {
        return;
    }
    const saved = store.setting('language') ?? navigator.language;
    languages.value = saved.startsWith('es') ? 'es' : 'en';
    speak(languages.value as Language);
    write(element('status'), () => say('loading'));
    const module = await compile().catch((error: unknown) => {
        throw new Error(say('noModule', messageOf(error)));
    });
    const renderer = await Renderer.create(module);
    const page = new Page(module, renderer);
    document.documentElement.dataset.instructionSet = instructionSet;
    element('live-save').hidden = !view.isServed;
    const use = async (texts: Texts | Promise<Texts>, isTyped = false, name?: string) => {
        const loaded = await texts;
        page.leave(true);
        page.clear();
        page.load(loaded, { isTyped, name });
        await page.render();
    };
    languages.addEventListener('change', () => {
        store.keepSetting('language', languages.value);
        speak(languages.value as Language);
        page.showEarlier();
        page.showFaults();
    });
    examples.addEventListener('change', () => {
        const name = examples.value;
        examples.value = '';
        use(example(name), false, name).catch((error: unknown) => page.say(() => say('noExample', messageOf(error))));
    });
    earlierTexts.addEventListener('change', () => {
        const texts = store.earlier()[Number(earlierTexts.value)];
        if (texts) {
            void use(texts, true);
        }
    });
    addEventListener('hashchange', () => {
        if (link.isLink(location.hash)) {
            const { hash } = location;
            link.read(hash).then(async (shared) => {
                // The user may have gone back meanwhile.
                if (location.hash === hash) {
                    entries.keep(page.entry);
                    await page.open({ ...shared, isTyped: false, isLink: true });
                }
            }).catch(() => page.say(() => say('badLink')));
        }
    });
    addEventListener('popstate', () => page.move());
    addEventListener('pagehide', () => entries.keep(page.entry));
    await page.open(await first(page));
    names().then(
        (all) => examples.append(...all.map((name) => new Option(name, name))),
        (error: unknown) => page.say(() => say('noExample', messageOf(error))),
    );
}

/** Shows an exception that no part of the page has expected. Browsers tell of some layouts by an event without one. */
function unexpected(error: unknown): void {
    if (error) {
        ['status', 'said'].forEach((name) => write(element(name), () => messageOf(error)));
    }
}

addEventListener('error', ({ error }) => unexpected(error));
addEventListener('unhandledrejection', ({ reason }) => unexpected(reason));
start().catch(unexpected);
