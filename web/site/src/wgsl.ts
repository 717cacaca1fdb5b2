// The colours of WGSL in an editor.
import { StreamLanguage } from '@codemirror/language';

const KEYWORDS = new Set(('alias break case const const_assert continue continuing default diagnostic discard else enable '
    + 'false fn for if let loop override return struct switch true var while').split(' '));

/** The language WGSL. */
export const wgsl = StreamLanguage.define<{ isInComment: boolean }>({
    startState: () => ({ isInComment: false }),
    token(stream, state) {
        if (state.isInComment || stream.match('/*')) {
            state.isInComment = !stream.skipTo('*/');
            if (state.isInComment) {
                stream.skipToEnd();
            } else {
                stream.match('*/');
            }
            return 'comment';
        }
        if (stream.match('//')) {
            stream.skipToEnd();
            return 'comment';
        }
        const word = stream.match(/^[A-Za-z_]\w*/) as RegExpMatchArray | null;
        if (word) {
            return KEYWORDS.has(word[0]) ? 'keyword' : stream.match(/^\s*\(/, false) ? 'name' : null;
        }
        if (stream.match(/^(?:0[xX][\da-fA-F]+|\.?\d[\w.]*)/)) {
            return 'number';
        }
        stream.next();
        return null;
    },
    languageData: { commentTokens: { line: '//' } },
});
