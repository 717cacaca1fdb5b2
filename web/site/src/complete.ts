// Offers the possible lines while the user types: the rows of the renderer's table, and the names of materials.
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';
import type { Row } from './module';
import { meaningOf, ofLanguage, say } from './words';

/** What a material's line begins with, and its name. */
const MATERIAL = /^[ \t]*(?:matte|metal|refractive):[ \t]+(\S+)/gm;

/** Returns the function that offers completions in a text whose lines `rows` describe. */
export function completions(rows: Row[]): (context: CompletionContext) => CompletionResult | null {
    return (context) => {
        const line = context.state.doc.lineAt(context.pos);
        const before = line.text.slice(0, context.pos - line.from);
        const word = /\S*$/.exec(before)?.[0] ?? '';
        if (word === '' && !context.explicit) {
            return null;
        }
        const from = context.pos - word.length;
        const words = before.slice(0, before.length - word.length).trim().split(/[ \t]+/).filter(Boolean);
        if (words.length === 0) {
            return { from, options: rows.map(tag), validFor: /^[\w:]*$/ };
        }
        const row = rows.find((one) => one.tag === words[0]);
        const names = row?.values.split(' ') ?? [];
        if (row?.default === '' && names[words.length - 1] === 'material') {
            const above = context.state.doc.sliceString(0, line.from);
            const known = new Set(Array.from(above.matchAll(MATERIAL), (match) => match[1] ?? ''));
            if (known.has(word) && !context.explicit) {
                // Enter would take the name that stands there already, instead of beginning a line.
                return null;
            }
            return { from, options: [...known].map((label) => ({ label, type: 'variable', detail: say('material') })) };
        }
        return null;
    };
}

function tag(row: Row): Completion {
    const start = row.default === '' ? '' : `; ${say('default')}: ${row.default}`;
    return {
        label: row.tag,
        type: 'keyword',
        detail: ofLanguage([row.values, row.spanishValues]),
        info: `${meaningOf(row.tag, row.meaning)}${start}`,
        apply(view, _, from, to) {
            // The rest of the line, if it has one, stays as it is, but not the rest of a word.
            const line = view.state.doc.lineAt(to);
            const rest = line.text.slice(to - line.from).replace(/^\w*:/, '').trimStart();
            const insert = `${row.tag} ${rest || row.default}`;
            const anchor = from + insert.length - rest.length;
            view.dispatch({ changes: { from, to: line.to, insert }, selection: { anchor }, userEvent: 'input.complete' });
        },
    };
}
