// What the page showed at the entries of the browser's history. Examples, links and tabs make entries, and Back leads
// to the one before. Entries with the same texts share them, so that going back to a tab loses nothing that was typed.
import { isLink, type View } from './link';
import type { Current } from './store';

/** What the page shows at an entry. */
export interface Entry extends Current {
    view: View | null;
    /** Whether the texts are those of a link. */
    isLink: boolean;
}

/** The state of an entry in the browser's history: the keys of its view and of its texts. */
interface State {
    key: string;
    load: string;
    /** Whether the entry stands below the first one, to keep the page from being left. */
    isGuard?: boolean;
    /** Whether there is such an entry. */
    isGuarded?: boolean;
}

/** What the entries of this page have shown. The browser's session storage has it too, for a page that is loaded again. */
const kept = new Map<string, string>();

let now: State = { key: '', load: '' };
let count = 0;

const unique = (): string => `render.entry.${Date.now()}.${count++}`;
const here = (): State | null => history.state as State | null;

/**
 * Takes the texts that are loaded now as those of the browser's entry. The texts of a link leave the address. Otherwise
 * they would replace later texts when the page is loaded again.
 */
export function begin(): void {
    // An entry that the browser has made for a link has others of this page below it.
    now = here()?.load ? here() as State : { key: unique(), load: unique(), isGuarded: now.load !== '' };
    history.replaceState(now, '', isLink(location.hash) ? location.pathname + location.search : undefined);
}

/** Keeps what the last entry has shown, until the tab is closed. */
export function keep({ view, ...texts }: Entry): void {
    for (const [key, value] of [[now.load, texts], [now.key, view]] as const) {
        kept.set(key, JSON.stringify(value));
        try {
            sessionStorage.removeItem(key);
            sessionStorage.setItem(key, JSON.stringify(value));
        } catch {
            // Without storage, an entry is kept until the page is left.
        }
    }
}

/** Begins a new entry, with other texts if `isLoad` holds. */
export function push(isLoad: boolean): void {
    guard();
    now = { ...now, key: unique(), load: isLoad ? unique() : now.load };
    history.pushState(now, '');
}

/** Puts an entry below the first one. {@link bounces} comes back from it. */
export function guard(): void {
    if (!now.isGuarded) {
        history.replaceState({ ...now, isGuard: true }, '');
        now = { ...now, isGuarded: true };
        history.pushState(now, '');
    }
}

/** Whether the browser is at the guard. Then it comes back into the page if `isUnsaved` holds, and leaves it otherwise. */
export function bounces(isUnsaved: boolean): boolean {
    if (here()?.isGuard) {
        isUnsaved ? history.forward() : history.back();
    }
    return here()?.isGuard === true;
}

/** Whether the browser has gone to another entry of this page. */
export const hasChanged = (): boolean => Boolean(here()?.load) && here()?.key !== now.key;

/** Whether the browser's entry has the texts that are shown. */
export const hasSameTexts = (): boolean => here()?.load === now.load;

/** Returns what the browser's entry has shown, or null if it is new. */
export function shown(): Entry | null {
    const read = (key = ''): unknown => JSON.parse(kept.get(key) ?? sessionStorage.getItem(key) ?? 'null');
    try {
        const texts = read(here()?.load) as Omit<Entry, 'view'> | null;
        return texts && { ...texts, view: read(here()?.key) as View | null };
    } catch {
        return null;
    }
}
