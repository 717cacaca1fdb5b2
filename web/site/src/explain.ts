// The life of a pixel of the exact picture, as the statement tells it: draws, rays, hits, colours and bytes.
import { Asked } from './asked';
import { definitions, objectName, type Definition } from './definitions';
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
    offsetText: ['x = {0}, y = {1}: numbers {2} and {3} of ray_rng_seed',
        'x = {0}, y = {1}: números {2} y {3} de ray_rng_seed'],
    target: ['Q', 'Q'],
    ray: ['ray', 'rayo'],
    rayText: ['{0} of at most {1}: depth {2}', '{0} de {1} como máximo: profundidad {2}'],
    from: ['from', 'desde'],
    along: ['along', 'dirección'],
    sphere: ['sphere', 'esfera'],
    side: ['side', 'lado'],
    top: ['upper base', 'base superior'],
    bottom: ['lower base', 'base inferior'],
    isCandidate: ['is a candidate', 'es candidata'],
    notCandidate: ['does not count: {0}', 'no cuenta: {0}'],
    tooNear: ['it is below 1e-3', 'es menor que 1e-3'],
    outsideRadius: ["its point is farther from the base's centre than the radius",
        'su punto dista del centro de la base más que el radio'],
    beyondBases: ['its point is farther along the axis than half the height',
        'su punto dista a lo largo del eje más que la mitad de la altura'],
    smallerCounts: ['the smaller root is a candidate', 'la raíz menor es candidata'],
    nearest: ['nearest', 'más cercano'],
    nearestText: ['object {0}, {1}, at lambda {2}', 'objeto {0}, {1}, con lambda {2}'],
    point: ['point', 'punto'],
    normalAt: ['normal', 'normal'],
    outward: ['{0}, outward: the ray comes from outside', '{0}, hacia fuera: el rayo viene de fuera'],
    turned: ['{0}, turned round: the ray comes from inside', '{0}, invertida: el rayo viene de dentro'],
    draws: ['draws', 'sorteos'],
    drawsText: ['{0}: {1} to {2} of material_rng_seed', '{0}: {1} a {2} de material_rng_seed'],
    vector: ['vector', 'vector'],
    addedToNormal: ['{0} is added to the normal', '{0} se suma a la normal'],
    addedToReflected: ['{0} is added to the reflected unit direction',
        '{0} se suma a la dirección reflejada unitaria'],
    rho: ["rho'", "rho'"],
    enters: ['is 1 / rho: the ray enters', 'es 1 / rho: el rayo entra'],
    leaves: ['is rho: the ray leaves', 'es rho: el rayo sale'],
    isReflected: ['{0}; it is reflected', '{0}; se refleja'],
    isRefracted: ['{0}; it is refracted', '{0}; se refracta'],
    matte: ['matte', 'mate'],
    metal: ['metal', 'metal'],
    refractive: ['refractive', 'refractante'],
    sendsText: ['sends a ray along {0}', 'envía un rayo en la dirección {0}'],
    colour: ['colour', 'color'],
    reflectanceText: ['of that ray is multiplied by the reflectance {0}',
        'de ese rayo se multiplica por la reflectancia {0}'],
    colourText: ['of the sample, times all reflectances: {0}', 'de la muestra, por todas las reflectancias: {0}'],
    end: ['end', 'final'],
    endDepth: ['{0}, black: the depth is used up', '{0}, negro: la profundidad está agotada'],
    endBackground: ['{0}, the background along the last ray, which hits nothing',
        '{0}, el fondo en la dirección del último rayo, que no toca nada'],
    moreSteps: ['…', '…'],
    moreStepsText: ['Only the first {0} steps are shown.', 'Solo se muestran los {0} primeros pasos.'],
    allSamples: ['all samples', 'todas las muestras'],
    mean: ['mean', 'media'],
    scaled: ['scaled', 'escalado'],
    bytes: ['bytes', 'bytes'],
    bytesText: ['{0}: truncated', '{0}: truncados'],
} satisfies Record<string, [english: string, spanish: string]>;

/** The parts of objects, and why a lambda does not count, as `literal` names them (`cli/literal/src/intersect.rs`). */
const PHRASES: Record<string, keyof typeof WORDS> = {
    'sphere': 'sphere', 'side': 'side', 'upper base': 'top', 'lower base': 'bottom',
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
    readonly #cancel = element<HTMLButtonElement>('explain-cancel');
    /** The worker. Another question ends one that is busy, and takes a new one. The button is shown meanwhile. */
    #worker: Asked<Omit<Question, 'question'>, { question: number; life: string }> | null = null;
    #newest = 0;
    #clicked: Explained['place'] = null;
    #objects: Definition[] = [];

    constructor(private readonly find: () => Explained | null, private readonly goTo: (line: number) => void) {
        this.#inputs.forEach((input) => input.addEventListener('change', () => void this.renew()));
        this.#cancel.addEventListener('click', () => {
            this.#stop();
            write(element('explain-said'), () => say('cancelled'));
        });
    }

    /** Cancels a question without an answer, and returns the number of the next one. */
    #stop(): number {
        if (!this.#cancel.hidden) {
            this.#worker?.end();
            this.#worker = null;
            this.#cancel.hidden = true;
        }
        return ++this.#newest;
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
        const own = this.#stop();
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
            this.#worker ??= new Asked('explaining.js');
            this.#cancel.hidden = false;
            const answer = await this.#worker.ask({ texts: [texts.config, texts.scene], numbers });
            const life = JSON.parse(answer.life) as Life;
            this.#cancel.hidden = true;
            if (life.message) {
                throw new Error(life.message);
            }
            limited('explain-sample', 'sample', life.count, 0);
            this.#objects = definitions(texts.scene).objects;
            const start = 3 * (row * width + column);
            this.#show(life, Array.from(data.subarray(start, start + 3)));
        } catch (error) {
            if (own === this.#newest) {
                this.#cancel.hidden = true;
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
        this.#add('bytes', () => tell('bytesText', bytes.join(' ')));
    }

    /** Adds the rows of a step. `depth` is the number of rays that a sample may send. */
    #tell(step: Step, depth: number): void {
        const phrase = (name: string) => tell(PHRASES[name] as keyof typeof WORDS);
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
                this.#add('ray', () => tell('rayText', depth - step.depth + 1, depth, step.depth), 'part');
                this.#add('from', () => at(step.origin));
                this.#add('along', () => at(step.direction));
                break;
            case 'candidate': {
                const verdict = () => (step.fault ? tell('notCandidate', phrase(step.fault)) : tell('isCandidate'));
                this.#add(step.object, () => `${phrase(step.part)}: lambda ${step.lambda} ${verdict()}`);
                break;
            }
            case 'hit': {
                const { draws, material, place, front, normal, direction } = step;
                this.#add('nearest', () => tell('nearestText', step.object, phrase(step.part), String(step.lambda)));
                this.#add('point', () => at(step.point));
                this.#add('normalAt', () => tell(front ? 'outward' : 'turned', at(normal)));
                if (draws.length > 0) {
                    this.#add('draws', () => tell('drawsText', draws.join(', '), place, place + draws.length - 1));
                }
                if (material === 'refractive') {
                    const outwards = direction.reduce((sum, part, axis) => sum + part * (normal[axis] ?? 0), 0);
                    this.#add('rho', () => tell(outwards > 0 ? 'isReflected' : 'isRefracted', tell(front ? 'enters' : 'leaves')));
                } else {
                    this.#add('vector', () => tell(material === 'matte' ? 'addedToNormal' : 'addedToReflected', at(step.vector)));
                }
                this.#add(material, () => tell('sendsText', at(direction)));
                this.#add('colour', () => tell('reflectanceText', at(step.reflectance)));
                break;
            }
            case 'end':
                this.#add('end', () => tell(step.reason === 'depth' ? 'endDepth' : 'endBackground', at(step.end)));
                this.#add('colour', () => tell('colourText', at(step.color)));
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
            write(link, () => objectName(one));
            head.append(link);
        } else {
            write(head, () => tell(about as keyof typeof WORDS));
        }
        write(cell, text);
        row.append(head, cell);
        this.#table.append(row);
    }
}
