// Files that the user chooses, drops on the page, or saves.
import { readFile, type Rgb } from './ppm';
import { messageOf } from './words';

/** A picture with the name of its file. */
export interface Named {
    name: string;
    picture: Rgb;
}

/** What a file is, by its name. */
const isPicture = ({ name }: File): boolean => /\.(ppm|pnm|png)$/i.test(name);
const isText = (file: File): boolean => !isPicture(file) && !/\.wgsl$/i.test(file.name);

/** Reads pictures. Throws with the name of the file that is none. */
export function namedOf(files: readonly File[]): Promise<Named[]> {
    return Promise.all(files.slice(0, 2).map(async (file) => {
        try {
            return { name: file.name, picture: await readFile(new Uint8Array(await file.arrayBuffer())) };
        } catch (error) {
            throw new Error(`${file.name}: ${messageOf(error)}`);
        }
    }));
}

/** Calls `take` with the files that the user chooses by a button, or drops anywhere: pictures, or texts. */
export function onFiles(
    button: HTMLElement, input: HTMLInputElement, kind: 'pictures' | 'texts', take: (files: File[]) => void,
): void {
    button.addEventListener('click', () => input.click());
    input.addEventListener('change', () => {
        take(Array.from(input.files ?? []));
        input.value = '';
    });
    const ofDrag = (event: DragEvent) => Array.from(event.dataTransfer?.files ?? []);
    document.addEventListener('dragover', (event) =>
        event.dataTransfer?.types.includes('Files') && event.preventDefault());
    document.addEventListener('drop', (event) => {
        const taken = ofDrag(event).filter(kind === 'pictures' ? isPicture : isText);
        if (taken.length > 0) {
            event.preventDefault();
            event.stopPropagation();
            take(taken);
        }
    }, { capture: true });
}

/** Lets the browser save a file. */
export function save(name: string, content: Blob): void {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(content);
    link.download = name;
    link.click();
    // The browser has begun to read the file when this time has passed.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
