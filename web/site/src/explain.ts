// The life of a pixel of the exact picture, as the statement tells it: draws, rays, hits, colours and bytes.
import { Asked } from './asked';
import { definitions, nameOf, type Definition } from './definitions';
import type { Question } from './explaining';
import { limited } from './limited';
import type { Rgb } from './ppm';
import type { Texts } from './store';
import { filled, messageOf, say, write } from './words';

const element = <E extends HTMLElement>(id: string): E => document.getElementById(id) as E;

/** A finished picture: its texts, its pixels, the numbers of random vectors before its rows, and the clicked pixel. */
export interface Explained {
    texts: Texts;
    pixels: Rgb;
    vectors: number[];
    place: [column: number, row: number] | null;
}

/** A step of a sample, as `literal::explain` tells it. Objects are counted from 1. */
type Step = { object: number; part: string; lambda: number } & (
    | { event: 'sample'; place: number; offset: number[]; target: number[] }
    | { event: 'ray'; depth: number; origin: number[]; direction: number[] }
    | { event: 'candidate'; fault: string }
    | { event: 'hit'; point: number[]; normal: number[]; front: boolean; material: 'matte' | 'metal' | 'refractive';
        place: number; draws: number[]; vector: number[]; direction: number[]; reflectance: number[] }
    | { event: 'end'; reason: 'background' | 'depth'; end: number[]; color: number[] });

/** The life of a pixel with the steps of one sample, or a message. */
interface Life {
    message?: string;
    samples: Step[];
    count: number;
    mean: number[];
    gamma: number;
    scaled: number[];
    bytes: number[];
}

/** The words of the view. They are loaded with it. */
const WORDS = {
    waits: ['Only a finished picture is explained.', 'Solo se explica una imagen terminada.'],
    same: ['Bytes {0}, as in the picture.', 'Bytes {0}, como en la imagen.'],
    differs: ['Bytes {0}; the picture has {1}, because there exact lambdas decide, and here rounding does.',
        'Bytes {0}; la imagen tiene {1}, porque allí deciden las lambdas exactas y aquí el redondeo.'],
    offset: ['offset', 'desplazamiento'],
    offsetText: ['x = {0}, y = {1}: draws {2} and {3} of the rays', 'x = {0}, y = {1}: números {2} y {3} de los rayos'],
    target: ['Q', 'Q'],
    ray: ['ray', 'rayo'],
    rayText: ['{0} of at most {1}', '{0} de {1} como máximo'],
    from: ['from', 'desde'],
    along: ['along', 'dirección'],
    sphere: ['sphere', 'esfera'],
    side: ['side', 'lado'],
    top: ['upper base', 'base superior'],
    bottom: ['lower base', 'base inferior'],
    counts: ['counts', 'cuenta'],
    tooNear: ['does not count: it is below 1e-3', 'no cuenta: es menor que 1e-3'],
    outsideRadius: ['does not count: it is outside of the radius', 'no cuenta: está fuera del radio'],
    beyondBases: ['does not count: it is beyond the bases', 'no cuenta: está más allá de las bases'],
    smallerCounts: ['does not count: the smaller root does', 'no cuenta: cuenta la raíz menor'],
    nearest: ['nearest', 'más cercano'],
    nearestText: ['object {0}, {1}, at lambda {2}', 'objeto {0}, {1}, con lambda {2}'],
    point: ['point', 'punto'],
    normalAt: ['normal', 'normal'],
    draws: ['draws', 'números'],
    drawsText: ['{0}: draws {1} to {2} of the materials', '{0}: números {1} a {2} de los materiales'],
    vector: ['vector', 'vector'],
    addedToNormal: ['is added to the normal', 'se suma a la normal'],
    addedToReflected: ['is added to the reflected unit direction', 'se suma a la dirección reflejada unitaria'],
    matte: ['matte', 'mate'],
    metal: ['metal', 'metal'],
    refractive: ['refractive', 'refractante'],
    sendsText: ['sends a ray along {0}', 'envía un rayo en la dirección {0}'],
    reflectance: ['reflectance', 'reflectancia'],
    end: ['end', 'final'],
    endDepth: ['black: the depth is used up', 'negro: la profundidad está agotada'],
    endBackground: ['the background: the ray hits nothing', 'el fondo: el rayo no toca nada'],
    colour: ['colour', 'color'],
    moreSteps: ['…', '…'],
    moreStepsText: ['Only the first {0} steps are shown.', 'Solo se muestran los {0} primeros pasos.'],
    allSamples: ['all samples', 'todas las muestras'],
    mean: ['mean', 'media'],
    scaled: ['scaled', 'escalado'],
    bytes: ['bytes', 'bytes'],
} satisfies Record<string, [english: string, spanish: string]>;

/** The parts of objects, and why a lambda does not count. */
const PHRASES: Record<string, keyof typeof WORDS> = {
    'sphere': 'sphere', 'side': 'side', 'upper base': 'top', 'lower base': 'bottom', '': 'counts',
    'it is below 1e-3': 'tooNear', 'it is outside of the radius': 'outsideRadius',
    'it is beyond the bases': 'beyondBases', 'the smaller root counts': 'smallerCounts',
};

const tell = (key: keyof typeof WORDS, ...values: (string | number)[]): string => filled(WORDS[key], ...values);

/** Largest number of steps that are shown. Between mirrors, a path may have any number. */
const MOST_STEPS = 2000;

const at = (vector: number[]): string => `(${vector.join(', ')})`;

/** The view. */
export class ExplainView {
    readonly #table = element('explain-steps');
    readonly #inputs = ['column', 'row', 'sample'].map((name) => element<HTMLInputElement>(`explain-${name}`));
    readonly #worker = new Asked<Omit<Question, 'question'>, { question: number; life: string }>('explaining.js');
    #newest = 0;
    #clicked: Explained['place'] = null;
    #objects: Definition[] = [];

    constructor(private readonly find: () => Explained | null, private readonly goTo: (line: number) => void) {
        this.#inputs.forEach((input) => input.addEventListener('change', () => void this.renew()));
    }

    /** The column and the row of the pixel. */
    get place(): [number, number] {
        return this.#inputs.slice(0, 2).map(({ value }) => Number(value)) as [number, number];
    }

    set place(place: [number, number]) {
        place.forEach((value, index) => (this.#inputs[index]!.value = String(value)));
    }

    /** Explains the chosen pixel of the picture, which may be new. A click into the picture has chosen another pixel. */
    async renew(): Promise<void> {
        const own = ++this.#newest;
        const found = this.find();
        this.#table.replaceChildren();
        write(element('explain-said'), () => (found ? say('busy') : tell('waits')));
        if (!found) {
            return;
        }
        const { texts, pixels: { width, height, data }, vectors, place } = found;
        if (place && place !== this.#clicked) {
            this.#clicked = this.place = place;
        }
        const [column, row] = [limited('explain-column', 'column', width), limited('explain-row', 'row', height)];
        try {
            const sample = Math.max(Number(this.#inputs[2]!.value), 0);
            const numbers: Question['numbers'] = [column, row, sample, vectors[row] ?? NaN];
            const answer = await this.#worker.ask({ texts: [texts.config, texts.scene], numbers });
            const life = JSON.parse(answer.life) as Life;
            if (own !== this.#newest) {
                return;
            }
            if (life.message) {
                throw new Error(life.message);
            }
            limited('explain-sample', 'sample', life.count, 0);
            this.#objects = definitions(texts.scene).objects;
            const start = 3 * (row * width + column);
            this.#show(life, Array.from(data.subarray(start, start + 3)));
        } catch (error) {
            if (own === this.#newest) {
                write(element('explain-said'), () => messageOf(error));
            }
        }
    }

    #show({ samples, mean, gamma, scaled, bytes }: Life, picture: number[]): void {
        write(element('explain-said'), () => tell(String(bytes) === String(picture) ? 'same' : 'differs',
            bytes.join(' '), picture.join(' ')));
        element('explain-said').style.setProperty('--color', `rgb(${bytes})`);
        const depth = samples.find((step) => step.event === 'ray')?.depth ?? 0;
        samples.slice(0, MOST_STEPS).forEach((step) => this.#tell(step, depth));
        if (samples.length > MOST_STEPS) {
            this.#add('moreSteps', () => tell('moreStepsText', MOST_STEPS));
        }
        this.#add('allSamples', () => '', 'part');
        this.#add('mean', () => at(mean));
        this.#add('scaled', () => `${at(scaled)} = 255 × ${tell('mean')}^(1 / ${gamma})`);
        this.#add('bytes', () => bytes.join(' '));
    }

    /** Adds the rows of a step. `depth` is the number of rays that a sample may send. */
    #tell(step: Step, depth: number): void {
        const part = () => tell(PHRASES[step.part] ?? 'sphere');
        switch (step.event) {
            case 'sample': {
                const { place, offset: [x, y] } = step;
                if (x !== undefined && y !== undefined) {
                    this.#add('offset', () => tell('offsetText', String(x), String(y), place, place + 1));
                }
                this.#add('target', () => at(step.target));
                break;
            }
            case 'ray':
                this.#add('ray', () => tell('rayText', depth - step.depth + 1, depth), 'part');
                this.#add('from', () => at(step.origin));
                this.#add('along', () => at(step.direction));
                break;
            case 'candidate':
                this.#add(step.object, () => `${part()}: lambda ${step.lambda} ${tell(PHRASES[step.fault] ?? 'counts')}`);
                break;
            case 'hit': {
                const { draws, material, place } = step;
                this.#add('nearest', () => tell('nearestText', step.object, part(), String(step.lambda)));
                this.#add('point', () => at(step.point));
                this.#add('normalAt', () => `${at(step.normal)}, ${say(step.front ? 'outside' : 'inside')}`);
                if (draws.length > 0) {
                    this.#add('draws', () => tell('drawsText', draws.join(', '), place, place + draws.length - 1));
                }
                if (material !== 'refractive') {
                    this.#add('vector', () => `${at(step.vector)} ${tell(material === 'matte' ? 'addedToNormal' : 'addedToReflected')}`);
                }
                this.#add(material, () => tell('sendsText', at(step.direction)));
                this.#add('reflectance', () => at(step.reflectance));
                break;
            }
            case 'end':
                this.#add('end', () => `${at(step.end)}, ${tell(step.reason === 'depth' ? 'endDepth' : 'endBackground')}`);
                this.#add('colour', () => at(step.color));
        }
    }

    /** Adds a row: what it is about, which may be the number of an object, and what it says. */
    #add(about: keyof typeof WORDS | number, text: () => string, name = ''): void {
        const row = document.createElement('tr');
        row.className = name;
        const [head, cell] = [document.createElement('th'), document.createElement('td')];
        const one = typeof about === 'number' ? this.#objects[about - 1] : undefined;
        if (one) {
            const link = document.createElement('a');
            link.href = '#scene-editor';
            link.addEventListener('click', (event) => {
                event.preventDefault();
                this.goTo(one.line);
            });
            write(link, () => nameOf(one.tag, one.line));
            head.append(link);
        } else {
            write(head, () => tell(about as keyof typeof WORDS));
        }
        write(cell, text);
        row.append(head, cell);
        this.#table.append(row);
    }
}
