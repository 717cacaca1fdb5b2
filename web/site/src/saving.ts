// Which text is not in its file yet, saving and opening, and changes of the files by other programs.
import type { Editor } from './editor';
import { save as download } from './files';
import type { TextNumber } from './module';
import type { Current } from './store';
import { isServed, files, MISSING, save, versions, type Files, type Pair } from './view';
import { element, messageOf, say, write } from './words';

/** Time between two questions whether a file has changed, in milliseconds. */
const PAUSE = 1000;

const NUMBERS = [0, 1] as const;
const NAMES = ['config', 'scene'] as const;

/** What the saving needs of the page. */
export interface Owner {
    /** Loads texts of the files. `isLost` tells whether unsaved texts are replaced. */
    load(texts: Pair<string>, isLost: boolean): void;
    /** Keeps the texts in the browser, with what {@link Saving.kept} says about them. */
    keep(): void;
    say(text: () => string): void;
}

/** The files of the two texts. Without `render-lab view`, a text is saved as a download. */
export class Saving {
    /** The texts as they are in their files, or as they were loaded; null if the user had typed and not saved them. */
    #saved: Pair<string | null> = ['', ''];
    /** The files that `render-lab view` has, as the page has read them. */
    #files: Files | null = null;
    /** Files that have changed while the user had unsaved texts, which the user may take. */
    #offered: Files | null = null;
    /** The last request. They follow each other, so that the page knows its own changes. */
    #last: Promise<unknown> = Promise.resolve();

    constructor(private readonly editors: Pair<Editor>, private readonly owner: Owner) {
        for (const number of NUMBERS) {
            element(`${NAMES[number]}-save`).addEventListener('click', () => void this.save(number));
            write(element(`${NAMES[number]}-save`), () => say(isServed ? 'save' : 'download'));
        }
        document.addEventListener('keydown', (event) => {
            if (event.key === 's' && (event.ctrlKey || event.metaKey)) {
                event.preventDefault();
                void this.#saveAll();
            }
        });
        element('offer-take').addEventListener('click', () => this.#take(true));
        element('offer-keep').addEventListener('click', () => this.#take(false));
    }

    /** Whether a text is not in its file. */
    isUnsaved(number: TextNumber): boolean {
        return this.editors[number].text !== this.#saved[number];
    }

    /** Whether one of the texts is not in its file. */
    get isAnyUnsaved(): boolean {
        return this.isUnsaved(0) || this.isUnsaved(1);
    }

    /** What the browser keeps about the files besides the texts. */
    get kept(): Pick<Current, 'files'> & { unsaved: Pair<boolean> } {
        const { versions, paths } = this.#files ?? {};
        const unsaved: Pair<boolean> = [this.isUnsaved(0), this.isUnsaved(1)];
        return versions && paths ? { files: { versions, paths }, unsaved } : { unsaved };
    }

    /** The name of the scene's file without its ending, or of its folder if the file has the usual name. */
    get name(): string | null {
        const [name = '', folder] = (this.#files?.paths[1] ?? '').split('/').reverse();
        const stem = name.replace(/\.[^.]*$/, '');
        return (stem === 'scene' ? folder : stem) || null;
    }

    /** Takes loaded texts as saved, except those that are `unsaved`. Files of `render-lab view` stay as they are. */
    loaded(unsaved: Current['unsaved'] = [false, false]): void {
        if (!this.#files) {
            this.#saved = [unsaved[0] ? null : this.editors[0].text, unsaved[1] ? null : this.editors[1].text];
        }
        this.mark();
    }

    /** Writes which texts are not saved. */
    mark(): void {
        for (const number of NUMBERS) {
            const isMissing = this.#files?.versions[number] === MISSING;
            const isUnsaved = this.isUnsaved(number);
            write(element(`${NAMES[number]}-state`), () =>
                (isMissing ? say('fileMissing') : isUnsaved && isServed ? say('unsaved') : ''));
        }
    }

    /**
     * Reads the files, and returns the texts to show: those of the files, or unsaved ones that the browser has kept. If
     * such a file has changed since, both are offered.
     */
    async open(kept: Current | null): Promise<Pair<string>> {
        const read = await files();
        const now: Files = { ...read, versions: [...read.versions] };
        this.#files = now;
        this.#saved = [...read.texts];
        const shown: Pair<string> = [...read.texts];
        for (const number of NUMBERS) {
            const [own, old] = [kept?.[NAMES[number]], kept?.files];
            if (own !== undefined && kept?.unsaved?.[number] && old?.paths[number] === read.paths[number]) {
                shown[number] = own;
                if (old.versions[number] !== read.versions[number] && own !== read.texts[number]) {
                    now.versions[number] = old.versions[number];
                    this.#offered = read;
                }
            }
        }
        this.#offer();
        this.#watch();
        return shown;
    }

    /** Saves a text into its file, or as a download. Returns whether it is saved. */
    async save(number: TextNumber): Promise<boolean> {
        const content = this.editors[number].text;
        if (!this.#files) {
            download(`${NAMES[number]}.txt`, new Blob([content], { type: 'text/plain' }));
            this.#saved[number] = content;
        } else {
            try {
                await this.#inTurn(async () => {
                    const { versions, paths } = this.#files as Files;
                    versions[number] = await save(number, versions[number], content);
                    this.#saved[number] = content;
                    this.owner.say(() => say('saved', paths[number].split('/').at(-1) ?? ''));
                });
            } catch (error) {
                this.owner.say(() => say('notSaved', messageOf(error)));
                return false;
            }
        }
        this.mark();
        this.owner.keep();
        return true;
    }

    async #saveAll(): Promise<void> {
        for (const number of NUMBERS) {
            if (this.isUnsaved(number) || this.#files?.versions[number] === MISSING) {
                await this.save(number);
            }
        }
    }

    #inTurn<T>(act: () => Promise<T>): Promise<T> {
        const result = this.#last.then(act);
        this.#last = result.catch(() => null);
        return result;
    }

    #watch(): void {
        const again = () => {
            this.#inTurn(() => this.#look()).catch((error: unknown) => this.owner.say(() => messageOf(error)))
                .finally(() => setTimeout(again, PAUSE));
        };
        setTimeout(again, PAUSE);
    }

    /** Loads a file that has changed, or offers it if its text in the editor is not saved. */
    async #look(): Promise<void> {
        const known = (this.#offered ?? this.#files)?.versions.join(' ');
        if (await versions() === known) {
            return;
        }
        const [read, old] = [await files(), this.#files as Files];
        const changed = NUMBERS.filter((number) => read.versions[number] !== old.versions[number]);
        const isLost = (number: TextNumber) => this.isUnsaved(number) && this.editors[number].text !== read.texts[number];
        const shown: Pair<string> = [this.editors[0].text, this.editors[1].text];
        this.#offered = null;
        for (const number of changed) {
            if (read.versions[number] === MISSING) {
                // Some editors remove a file before they write it again.
                old.versions[number] = MISSING;
            } else if (isLost(number)) {
                this.#offered = read;
            } else {
                [old.versions[number], this.#saved[number], shown[number]] =
                    [read.versions[number], read.texts[number], read.texts[number]];
            }
        }
        this.#offer();
        if (NUMBERS.some((number) => shown[number] !== this.editors[number].text)) {
            this.owner.load(shown, false);
            this.owner.say(() => say('reloaded'));
        }
        this.mark();
    }

    #offer(): void {
        element('offer').hidden = this.#offered === null;
    }

    /** Takes the changed files, or keeps the texts of the editors, which may then replace these files. */
    #take(isTaken: boolean): void {
        const [read, old] = [this.#offered, this.#files];
        this.#offered = null;
        this.#offer();
        if (!read || !old) {
            return;
        }
        const shown: Pair<string> = [this.editors[0].text, this.editors[1].text];
        for (const number of NUMBERS.filter((one) => read.versions[one] !== old.versions[one])) {
            shown[number] = isTaken ? read.texts[number] : shown[number];
        }
        [this.#files, this.#saved] = [read, [...read.texts]];
        if (isTaken) {
            this.owner.load(shown, true);
        }
        this.mark();
        this.owner.keep();
    }
}
