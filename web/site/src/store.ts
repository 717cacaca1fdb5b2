// Keeps what the user types in the browser's local storage. Texts that are replaced stay in a list of earlier texts.

import { definitions } from './definitions';
import type { Edits } from './gpu/compose';

/** A configuration and a scene. */
export interface Texts {
    config: string;
    scene: string;
    /** The user's texts of WGSL modules; without them, those of the page stay. */
    modules?: Edits;
}

/** Whether both texts of two pairs are the same. */
export const isSame = (one: Texts, other: Texts): boolean => one.config === other.config && one.scene === other.scene;

/** Texts that the user had before others were loaded. */
export interface Earlier extends Texts {
    /** When they were replaced, in milliseconds since 1970. */
    time: number;
}

/** The texts of the editors. */
export interface Current extends Texts {
    /** Whether the user has changed them since they were loaded. */
    isTyped: boolean;
    /** The files of `render-lab view` that were loaded last. */
    files?: { versions: [config: string, scene: string]; paths: [config: string, scene: string] };
    /** Whether each text is not in its file. */
    unsaved?: [config: boolean, scene: boolean];
    /** The name of the scene, for pictures. */
    name?: string;
}

const CURRENT = 'render.texts';
const EARLIER = 'render.earlier';
const MODULES = 'render.modules';

/** Largest number of earlier texts. */
const MAX_EARLIER = 20;

const isTexts = (value: unknown): value is Texts =>
    typeof value === 'object' && value !== null && 'config' in value && 'scene' in value
    && typeof value.config === 'string' && typeof value.scene === 'string';

function read(key: string): unknown {
    try {
        return JSON.parse(localStorage.getItem(key) ?? 'null');
    } catch {
        return null;
    }
}

/** Returns a setting that was kept, or null. */
export function setting(name: string): string | null {
    const value = read(`render.${name}`);
    return typeof value === 'string' ? value : null;
}

/** Keeps a setting. Where the browser does not allow it, the setting counts until the page is closed. */
export function keepSetting(name: string, value: string): void {
    try {
        write(`render.${name}`, value);
    } catch {
        // Nothing is lost that the user has typed.
    }
}

/** Returns the entries of a value that are texts. */
export function editsOf(value: unknown): Edits {
    const entries = typeof value === 'object' && value !== null ? Object.entries(value) : [];
    return Object.fromEntries(entries.filter((entry): entry is [string, string] => typeof entry[1] === 'string'));
}

/** Returns the WGSL modules that were kept, or none. */
export const modules = (): Edits => editsOf(read(MODULES));

/** Keeps the user's WGSL modules. Throws if the browser does not allow it. */
export function keepModules(edits: Edits): void {
    write(MODULES, edits);
}

/** Returns the texts that the editors had last, or null. */
export function current(): Current | null {
    const value = read(CURRENT);
    return isTexts(value) ? { isTyped: true, ...value } : null;
}

/** Returns the earlier texts, the newest first. */
export function earlier(): Earlier[] {
    const value = read(EARLIER);
    const all = Array.isArray(value) ? value.filter((one): one is Earlier => isTexts(one) && 'time' in one) : [];
    return all.map((one) => ({ ...one, modules: editsOf(one.modules) }));
}

/** Writes `value`. The oldest of the earlier texts give way if there is too little room. */
function write(key: string, value: unknown): void {
    try {
        localStorage.setItem(key, JSON.stringify(value));
    } catch (error) {
        const isList = key === EARLIER;
        const rest = (isList ? value as Earlier[] : earlier()).slice(0, -1);
        if (isList ? rest.length === 0 : !localStorage.getItem(EARLIER)) {
            throw error;
        }
        if (!isList) {
            localStorage.removeItem(EARLIER);
            rest.length > 0 && localStorage.setItem(EARLIER, JSON.stringify(rest));
        }
        write(key, isList ? rest : value);
    }
}

/** Returns the number of objects of texts, and the last width of the picture. */
export function sizes({ config, scene }: Texts): [objects: number, width: string] {
    const width = Array.from(config.matchAll(/^\s*image_width:\s*(\S+)/gm)).at(-1)?.[1];
    return [definitions(scene).objects.length, width ? `, ${width} px` : ''];
}

/** Keeps the texts of the editors. Throws if the browser does not allow it. */
export function keep(texts: Current): void {
    write(CURRENT, texts);
}

/** Puts texts that are about to be replaced at the front of the earlier texts. */
export function keepEarlier(texts: Texts): void {
    const content = ({ config, scene, modules: edits }: Texts) => JSON.stringify([config, scene, edits ?? {}]);
    const others = earlier().filter((one) => content(one) !== content(texts));
    write(EARLIER, [{ ...texts, time: Date.now() }, ...others].slice(0, MAX_EARLIER));
}
