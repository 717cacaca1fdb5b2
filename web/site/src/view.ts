// What the page does when the program `render-lab view` serves it: it loads two files, and loads them again when they
// change.
import type { Texts } from './store';

/** Time between two questions whether a file has changed, in milliseconds. */
const PAUSE = 1000;

/** Whether `render-lab view` serves the page. The program writes it into the page. */
export const isServed = document.querySelector<HTMLMetaElement>('meta[name=served-by]')?.content === 'render-lab view';

/** What a watch of the files tells. */
export interface Listener {
    changed(texts: Texts): void;
    /** A file cannot be read, or the program does not answer. */
    failed(text: string | null): void;
}

interface Files extends Texts {
    version: string;
}

async function files(): Promise<Files> {
    const response = await fetch('view/files');
    if (!response.ok) {
        throw new Error(await response.text());
    }
    return response.json() as Promise<Files>;
}

/** Returns the texts of both files, and calls `listener` whenever one of them changes. */
export async function watch(listener: Listener): Promise<Texts> {
    const first = await files();
    let version = first.version;
    const look = async () => {
        const response = await fetch('view/version').catch(() => null);
        if (!response) {
            listener.failed(null);
        } else {
            const now = await response.text();
            if (now !== version) {
                version = now;
                const changed = await files();
                version = changed.version;
                listener.changed(changed);
            }
        }
    };
    const again = () => {
        look().catch((error: unknown) => listener.failed(error instanceof Error ? error.message : String(error)))
            .finally(() => setTimeout(again, PAUSE));
    };
    setTimeout(again, PAUSE);
    return first;
}
