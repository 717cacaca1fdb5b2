// The requests to the program `render-lab view`, if it serves the page: two files, their versions, and saving.
import type { TextNumber } from './module';
import { ask } from './secret';
import { say } from './words';

/** Something for the configuration, and for the scene. */
export type Pair<T> = [config: T, scene: T];

/** Both files. */
export interface Files {
    texts: Pair<string>;
    versions: Pair<string>;
    paths: Pair<string>;
}

/** The version of a file that does not exist. */
export const MISSING = 'missing';

/** Whether `render-lab view` serves the page. The program writes it into the page. */
export const isServed = document.querySelector<HTMLMetaElement>('meta[name=served-by]')?.content === 'render-lab view';

/** The status of an answer that tells that the file has changed. */
const CONFLICT = 409;

/** Returns the bytes of an answer. Throws with the program's words, or if the program does not answer. */
async function answer(path: string, options: RequestInit = {}): Promise<Uint8Array> {
    const response = await ask(path, options).catch(() => {
        throw new Error(say('unreachable'));
    });
    if (!response.ok) {
        throw new Error(response.status === CONFLICT ? say('fileChanged') : await response.text());
    }
    return new Uint8Array(await response.arrayBuffer());
}

const text = (bytes: Uint8Array): string => new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes);

/** Returns both files. */
export async function files(): Promise<Files> {
    // A line of JSON, then the configuration, then the scene.
    const bytes = await answer('view/files');
    const start = bytes.indexOf('\n'.charCodeAt(0)) + 1;
    const { version, path, length } =
        JSON.parse(text(bytes.subarray(0, start))) as { version: Pair<string>; path: Pair<string>; length: number };
    const texts: Pair<string> = [text(bytes.subarray(start, start + length)), text(bytes.subarray(start + length))];
    return { texts, versions: version, paths: path };
}

/** Returns the versions of both files, with a blank between them. */
export const versions = async (): Promise<string> => text(await answer('view/version'));

/** Saves a text over this version of its file, and returns the new version. Throws if the file has changed. */
export const save = async (number: TextNumber, version: string, content: string): Promise<string> =>
    text(await answer(`view/${number === 0 ? 'config' : 'scene'}`, { method: 'POST', body: `${version}\n${content}` }));
