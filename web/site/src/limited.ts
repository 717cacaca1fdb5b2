// A field for a whole number from 0 on, with its limit in its label.
import { element, type Key, say, write } from './words';

/** Returns the number in the field `id`, limited to 0 to `size - 1`. An empty field begins with `first`. */
export function limited(id: string, key: Key, size: number, first = Math.floor(size / 2)): number {
    const input = element<HTMLInputElement>(id);
    write(input.previousElementSibling as HTMLElement, () => say('range', say(key), size - 1));
    input.max = String(size - 1);
    const value = Math.min(Math.max(Math.floor(Number(input.value || first) || 0), 0), size - 1);
    input.value = String(value);
    return value;
}
