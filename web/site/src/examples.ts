// The examples are the folders of scenes/, which the build copies.
import type { Texts } from './store';

/** The example of a page that has no texts yet. It takes a third of the time of `materials`. */
export const FIRST = 'spheres';

async function load(path: string): Promise<Response> {
    const response = await fetch(`scenes/${path}`);
    if (!response.ok) {
        throw new Error(`${response.url}: ${response.status}`);
    }
    return response;
}

/** Returns the names of the examples. */
export async function names(): Promise<string[]> {
    return (await load('names.json')).json() as Promise<string[]>;
}

/** Returns the texts of an example. */
export async function example(name: string): Promise<Texts> {
    const [config, scene] = await Promise.all(
        ['config', 'scene'].map(async (file) => (await load(`${name}/${file}.txt`)).text()),
    );
    return { config: config ?? '', scene: scene ?? '' };
}
