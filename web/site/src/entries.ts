// Brings back what the page showed at an earlier entry of the browser's history. A link that is opened over other texts
// makes a new entry, and Back leads to the entry before it.
import { isLink, type View } from './link';
import type { Current } from './store';

/** What the page shows at an entry. */
export interface Entry extends Current {
    view: View | null;
    /** Whether the texts are those of a link. */
    isLink: boolean;
}

/** The entries that this page has left. The browser's session storage has them too, for a page that is loaded again. */
const entries = new Map<string, Entry>();

/** The key of the entry that is shown. The browser's history has it as the state of the entry. */
let key = '';

const here = (): string | null => (typeof history.state === 'string' ? history.state : null);

/**
 * Takes the texts that are loaded now as those of the browser's entry. The texts of a link leave the address. Otherwise
 * they would replace later texts when the page is loaded again.
 */
export function begin(): void {
    key = here() ?? `render.entry.${Date.now()}`;
    history.replaceState(key, '', isLink(location.hash) ? location.pathname + location.search : undefined);
}

/** Keeps what the last entry has shown, until the tab is closed. */
export function keep(entry: Entry): void {
    entries.set(key, entry);
    try {
        sessionStorage.removeItem(key);
        sessionStorage.setItem(key, JSON.stringify(entry));
    } catch {
        // Without storage, an entry is kept until the page is left.
    }
}

/** Whether the browser has gone to another entry of this page. */
export const hasChanged = (): boolean => here() !== null && here() !== key;

/** Returns what the browser's entry has shown, or null if it is new. */
export function shown(): Entry | null {
    try {
        const own = here() ?? '';
        return entries.get(own) ?? JSON.parse(sessionStorage.getItem(own) ?? 'null') as Entry | null;
    } catch {
        return null;
    }
}
