// Sliders and colour pickers for the numbers of a shader. They change the text, so links and undoing have them too.
//
//     override gain: f32 = 0.5; // slider 0..1 step .01
//     const tint = vec3<real>(1.0, 0.5, 0.2); // color
import type { Editor } from './editor';

/** A number in decimal notation, as a regular expression. */
export const NUMBER = String.raw`[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?`;

/** An override constant with a slider. */
const SLIDER = new RegExp(
    String.raw`^[ \t]*override[ \t]+(\w+)[^=\n]*=[ \t]*(${NUMBER})[fh]?[ \t]*;[ \t]*//[ \t]*slider[ \t]+`
    + String.raw`(${NUMBER})\.\.(${NUMBER})(?:[ \t]+step[ \t]+(${NUMBER}))?`, 'gmd');

/** A vector of three numbers with a colour picker. */
const COLOR = new RegExp(
    String.raw`^[ \t]*(?:const|let|var)[ \t]+(\w+)[^=\n]*=[ \t]*vec3\w*(?:<\w+>)?\(([^;\n]*)\)[ \t]*;[ \t]*//[ \t]*colou?r\b`,
    'gmd');

/** A number of a shader that the user changes without typing, at its place in the text. */
interface Knob {
    kind: 'range' | 'color';
    name: string;
    value: string;
    from: number;
    to: number;
    limits: { min: string; max: string; step: string };
}

/** Returns a number in a form that WGSL takes for f32. */
const float = (text: string): string => (/[.eE]/.test(text) ? text : `${text}.0`);

/** Returns two hexadecimal digits for a channel from 0 to 1. */
export const hex = (channel: number): string => Math.round(255 * Math.min(Math.max(channel, 0), 1)).toString(16).padStart(2, '0');

/** Returns the knobs of a text. */
function knobsOf(text: string): Knob[] {
    const sliders = Array.from(text.matchAll(SLIDER), (match): Knob => {
        const [, name = '', value = '', min = '', max = '', step = 'any'] = match;
        const [from, to] = match.indices?.[2] ?? [0, 0];
        return { kind: 'range', name, value, from, to, limits: { min, max, step } };
    });
    const colors = Array.from(text.matchAll(COLOR), (match): Knob | null => {
        const channels = (match[2] ?? '').match(new RegExp(NUMBER, 'g'))?.map(Number) ?? [];
        const [from, to] = match.indices?.[2] ?? [0, 0];
        const value = `#${channels.map(hex).join('')}`;
        return channels.length === 3
            ? { kind: 'color', name: match[1] ?? '', value, from, to, limits: { min: '', max: '', step: '' } }
            : null;
    });
    return [...sliders, ...colors.filter((knob) => knob !== null)].sort((one, other) => one.from - other.from);
}

/** The sliders and pickers below an editor. */
export class Knobs {
    constructor(private readonly parent: HTMLElement, private readonly editor: Editor) {}

    /** Shows the knobs of the editor's text. Those that are there already stay, because the user may hold one. */
    show(): void {
        const knobs = knobsOf(this.editor.text);
        const inputs = Array.from(this.parent.querySelectorAll('input'));
        const shown = inputs.map((input) => `${input.type} ${input.name}`).join();
        if (shown !== knobs.map((knob) => `${knob.kind} ${knob.name}`).join()) {
            this.parent.replaceChildren(...knobs.map((knob) => this.#label(knob)));
        }
        this.parent.querySelectorAll('input').forEach((input, index) => {
            const knob = knobs[index];
            if (knob) {
                Object.assign(input, knob.limits);
                if (document.activeElement !== input) {
                    input.value = knob.value;
                }
                (input.nextElementSibling as HTMLElement).textContent = knob.value;
            }
        });
    }

    #label({ kind, name }: Knob): HTMLElement {
        const label = document.createElement('label');
        const input = document.createElement('input');
        input.type = kind;
        input.name = name;
        input.addEventListener('input', () => this.#turn(name, input.value));
        label.append(`${name} `, input, document.createElement('output'));
        return label;
    }

    /** Writes the value of a knob into the text. */
    #turn(name: string, value: string): void {
        const knob = knobsOf(this.editor.text).find((one) => one.name === name);
        if (knob?.kind === 'range') {
            this.editor.replace(knob.from, knob.to, float(value));
        } else if (knob) {
            const channels = [1, 3, 5].map((place) => parseInt(value.slice(place, place + 2), 16) / 255);
            const texts = channels.map((channel) => float(String(Number(channel.toFixed(3)))));
            this.editor.replace(knob.from, knob.to, texts.join(', '));
        }
    }
}
