// What the lines of a scene define: the words for the numbers of objects and materials.
import { say, write } from './words';

/** The lines of a scene that define objects, and those that define materials, each in the order of their numbers. */
export interface Definitions {
    objects: Definition[];
    materials: Definition[];
}

/** A line, its first word without the colon, and the name of a material. */
export interface Definition {
    line: number;
    tag: string;
    name: string;
}

/** Returns the definitions of a scene without an error. */
export function definitions(scene: string): Definitions {
    const all = scene.split('\n').map((row, index) => {
        const [tag = '', name = ''] = row.trim().split(/\s+/);
        return { line: index + 1, tag: tag.slice(0, -1), name };
    });
    const of = (...tags: string[]) => all.filter(({ tag }) => tags.includes(tag));
    return { objects: of('sphere', 'cylinder'), materials: of('matte', 'metal', 'refractive') };
}

/** Returns the words for a line, such as "gold, line 20". */
export const nameOf = (word: string, line: number): string => `${word}, ${say('line', line).toLowerCase()}`;

/** Returns the words for an object, such as "cylinder, line 20". */
export const objectName = ({ tag, line }: Definition): string => nameOf(say(tag === 'sphere' ? 'sphere' : 'cylinder'), line);

/** Returns a link with words that `goTo` obeys: it shows the line of a definition in the editor. */
export function linkTo({ line }: Definition, words: () => string, goTo: (line: number) => void): HTMLElement {
    const link = document.createElement('a');
    link.href = '#scene-editor';
    link.addEventListener('click', (event) => {
        event.preventDefault();
        goTo(line);
    });
    write(link, words);
    return link;
}
