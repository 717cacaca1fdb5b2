// Joins WGSL modules into one text, and finds the module of a line. The renderer's module lists the modules.

import { say } from '../words';

/** A WGSL module. */
export interface Module {
    name: string;
    path: string;
    source: string;
    /** Names of the modules that a composition of this one joins, in order. */
    needed: string[];
}

/** The user's own texts of modules, by their names. */
export type Edits = Record<string, string>;

/** A joined text with the modules whose lines it has. */
export interface Composition {
    code: string;
    parts: { name: string; path: string; source: string }[];
    /** The loops in texts of the user, which end when they do not end themselves. */
    loops: ShaderFault[];
}

/** A fault in a composition, at its place in the module's own text. */
export interface ShaderFault {
    /** The name of the module; empty if the fault is about none. */
    module: string;
    path: string;
    /** Counted from 1; 0 if the fault is about no line. */
    line: number;
    /** Counted from 1, in units of UTF-16. */
    column: number;
    length: number;
    message: string;
}

/** What makes `probe(value);` a statement that stores the value. It stays on its line, so that places stay true. */
const PROBE = /\bprobe\s*\(/g;

/** A line that begins with a directive. */
const DIRECTIVE = /^\s*(enable|requires|diagnostic)\b/;

/** The binding with the number of a loop that was ended, from 1. */
export const ENDED = 9;

/** A loop up to its body. */
const LOOP = /\b(?:loop|while|for)\b[^{]*\{/g;

/** The statement at the start of the body of the user's loop number `loop`. All have the same length. */
const guarded = (loop: number): string => ` if !loop_goes_on(${String(loop).padStart(4)}u) { break; }`;

/** What stands before all modules, so that each of them can call `probe`. */
const PROBED = 'var<private> probed: vec3<f32>;';

/**
 * What stands there too if the user's texts have loops. A device never ends a loop, and the browser waits for it. 2^24
 * rounds of an invocation are five times as many as a loop over 65,535 objects takes at a depth of 50.
 */
const GUARD = `@group(0) @binding(${ENDED}) var<storage, read_write> ended_loop: atomic<u32>; var<private> rounds: u32; `
    + 'fn loop_goes_on(number: u32) -> bool { rounds++; if rounds > 16777216u { atomicMax(&ended_loop, number); } '
    + 'return rounds <= 16777216u && (rounds % 256u != 0u || atomicLoad(&ended_loop) == 0u); }';

/** Whether a text has a call of `probe`. */
export const hasProbe = (source: string): boolean => withoutComments(source).search(PROBE) >= 0;

/** Replaces comments by blanks, and keeps all places. */
export function withoutComments(source: string): string {
    return source.replace(/\/\/[^\n]*|\/\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ' '));
}

/** Replaces each call of `probe` by an assignment with as many characters before the value. */
function withProbes(source: string): string {
    const calls = Array.from(withoutComments(source).matchAll(PROBE), (match) => match.index).reverse();
    return calls.reduce((text, place) => {
        const open = text.indexOf('(', place);
        return `${text.slice(0, place)}probed = vec3<f32>(${text.slice(open + 1)}`;
    }, source);
}

/** The number of characters by which {@link withProbes} moves what follows a call, and {@link withGuards} a loop. */
const [MOVED, MOVED_BY_LOOP] = ['probed = vec3<f32>('.length - 'probe('.length, guarded(0).length];

/** Lets each loop of a text end, and adds it to `loops` as the fault that it is then. */
function withGuards(part: Composition['parts'][number], loops: ShaderFault[]): string {
    const plain = withoutComments(part.source);
    const ends = Array.from(plain.matchAll(LOOP), ({ index, 0: { length } }) => {
        const name = Array.from(plain.slice(0, index).matchAll(/\bfn\s+(\w+)/g)).at(-1)?.[1] ?? '';
        const rows = plain.slice(0, index).split('\n');
        const [column, message] = [(rows.at(-1) ?? '').length + 1, say('endlessLoop', name)];
        loops.push({ module: part.name, path: part.path, line: rows.length, column, length: 4, message });
        return [index + length, loops.length] as const;
    });
    return ends.reduceRight((text, [end, loop]) => text.slice(0, end) + guarded(loop) + text.slice(end), part.source);
}

const ended = (text: string): string => (text.endsWith('\n') ? text : `${text}\n`);

/**
 * Joins the modules that `roots` need, each in the user's text if there is one, and the page's `own` text. Rays find
 * their closest hit in the hierarchy if `inHierarchy` holds, and otherwise by a loop over all objects.
 */
export function compose(
    modules: readonly Module[],
    roots: readonly string[],
    edits: Edits,
    inHierarchy: boolean,
    own = '',
): Composition {
    const neededBy = (names: readonly string[]) =>
        names.flatMap((name) => modules.find((one) => one.name === name)?.needed ?? []);
    const needed = new Set(neededBy(roots));
    if (inHierarchy && needed.delete('closest_hit')) {
        neededBy(['hierarchy']).forEach((name) => needed.add(name));
    }
    // The first module defines the number type. The list has each module after those that it needs.
    const parts = modules.filter(({ name }, index) => index === 0 || needed.has(name))
        .map(({ name, path, source }) => ({ name, path, source: ended(edits[name] ?? source).replace(/^\uFEFF/, ' ') }));
    const loops: ShaderFault[] = [];
    const sources = parts.map((part) => withProbes(part.name in edits ? withGuards(part, loops) : part.source));
    const code = `${PROBED}${loops.length > 0 ? ` ${GUARD}` : ''}\n${sources.join('')}${own}`;
    return { code, parts, loops };
}

/** Returns the place of a fault in its module. `line` and `column` are places in the composition, counted from 1. */
export function locate({ parts, loops }: Composition, line: number, column: number, length: number, message: string): ShaderFault {
    let first = 2;
    for (const { name, path, source } of parts) {
        const lines = source.split('\n').length - 1;
        if (line >= first && line < first + lines) {
            const own = line - first + 1;
            const text = source.split('\n')[own - 1] ?? '';
            const plain = withoutComments(text);
            const call = plain.search(PROBE);
            const before = Array.from(plain.matchAll(LOOP)).filter((loop, index) =>
                column > loop.index + loop[0].length + (index + 1) * MOVED_BY_LOOP).length;
            const inLoops = loops.some(({ module }) => module === name) ? before * MOVED_BY_LOOP : 0;
            const moved = inLoops + (call >= 0 && column > call + inLoops + MOVED ? MOVED : 0);
            // A browser advises to move a directive to the start of the text, where it is already.
            const words = DIRECTIVE.test(text) ? say('directive') : message;
            return { module: name, path, line: own, column: Math.max(column - moved, 1), length, message: words };
        }
        first += lines;
    }
    return { module: '', path: '', line: 0, column: 0, length: 0, message };
}

/** The start of the image kernel, with what only an entry point may have. */
const ENTRY = /@compute[^\n]*(\n\s*fn\s+image\s*\(\s*)@builtin\(global_invocation_id\)/;

/** Makes the image kernel a function that another kernel can call. All lines stay where they are. */
export function withoutEntry(composition: Composition): Composition {
    return { ...composition, code: composition.code.replace(ENTRY, '$1') };
}
