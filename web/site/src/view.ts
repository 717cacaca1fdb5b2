// What the page does when the program `render-lab view` serves it: it loads two files, loads them again when they
// change, and saves a camera into the configuration when the user asks for it.
import { ask } from './secret';
import type { Texts } from './store';
import { messageOf, say } from './words';

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
    const response = await ask('view/files');
    if (!response.ok) {
        throw new Error(await response.text());
    }
    // A line with the version and the length of the configuration, then the configuration, then the scene.
    const bytes = new Uint8Array(await response.arrayBuffer());
    const text = (from: number, to?: number) => new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes.subarray(from, to));
    const start = bytes.indexOf('\n'.charCodeAt(0)) + 1;
    const [now = '', length] = text(0, start).split(' ');
    const end = start + Number(length);
    return { version: now, config: text(start, end), scene: text(end) };
}

/** The version of the files that the page has read. */
let version = '';

/** The last request that reads or changes the version. They follow each other, so that the page knows its own changes. */
let last: Promise<unknown> = Promise.resolve();

function inTurn<T>(act: () => Promise<T>): Promise<T> {
    const result = last.then(act);
    last = result.catch(() => null);
    return result;
}

/** The status of an answer that tells that a file has changed. */
const CONFLICT = 409;

/** Writes the three lines of a camera into the configuration file. Throws if the file has changed, or cannot be written. */
export const save = (lines: string[]): Promise<void> => inTurn(async () => {
    const request = { method: 'POST', body: JSON.stringify({ version, lines }) };
    const response = await ask('view/camera', request).catch(() => {
        throw new Error(say('unreachable'));
    });
    const text = await response.text();
    if (!response.ok) {
        throw new Error(response.status === CONFLICT ? say('fileChanged') : text);
    }
    version = text;
});

/** Returns the texts of both files, and calls `listener` whenever one of them changes. */
export async function watch(listener: Listener): Promise<Texts> {
    const first = await files();
    version = first.version;
    document.getElementById('live-save')!.hidden = false;
    const look = async () => {
        const response = await ask('view/version').catch(() => null);
        if (!response?.ok) {
            listener.failed(response && await response.text());
        } else if (await response.text() !== version) {
            const changed = await files();
            // The files may have their old content again.
            if (changed.version !== version) {
                version = changed.version;
                listener.changed(changed);
            }
        }
    };
    const again = () => {
        inTurn(look).catch((error: unknown) => listener.failed(messageOf(error)))
            .finally(() => setTimeout(again, PAUSE));
    };
    setTimeout(again, PAUSE);
    return first;
}
