// The life of a pixel of the exact picture, as the statement tells it: draws, rays, hits, colours and bytes.
import { Asked } from './asked';
import { definitions, linkTo, objectName, type Definition } from './definitions';
import type { Question } from './explaining';
import { limited } from './limited';
import type { Rgb } from './ppm';
import type { Texts } from './store';
import { element, filled, messageOf, ofLanguage, say, write } from './words';

/** A finished picture: its texts, its pixels, the numbers of random vectors before its rows, and the clicked pixel. */
export interface Explained {
    texts: Texts;
    pixels: Rgb;
    vectors: number[];
    place: [column: number, row: number] | null;
}

/** A step of a sample, as `literal::explain` tells it. Objects are counted from 1. */
type Step = { object: number; part: string; lambda: number | null } & (
    | { event: 'sample'; place: number; offset: number[]; target: number[] }
    | { event: 'ray'; depth: number; origin: number[]; direction: number[] }
    | { event: 'candidate'; fault: string; reach?: number[] }
    | { event: 'hit'; point: number[]; normal: number[]; front: boolean; material: 'matte' | 'metal' | 'refractive';
        place: number; draws: number[]; half: number; vector: number[]; direction: number[]; reflectance: number[];
        refraction: Refraction | null }
    | { event: 'end'; reason: 'background' | 'depth'; m: number | null; end: number[]; color: number[] });

/** What decides whether a refractive surface reflects a ray. `product` is rho' sin. */
interface Refraction {
    index: number;
    ratio: number;
    cos: number;
    sin: number;
    product: number;
    reflects: boolean;
}

/** The life of a pixel with the steps of one sample, or a message. */
interface Life {
    message?: string;
    samples: Step[];
    count: number;
    window: number[][];
    background: number[][];
    mean: number[];
    gamma: number;
    scaled: number[];
    bytes: number[];
}

/** A text in both languages. */
type Both = readonly [english: string, spanish: string];

/** What the view says about its table. */
const WAITS: Both = ['Only a finished picture is explained.', 'Solo se explica una imagen terminada.'];
const SAME: Both = ['Bytes {0}, as in the picture.', 'Bytes {0}, como en la imagen.'];
const BESIDE: Both = [' {0} has {1}.', ' {0} tiene {1}.'];
const DIFFERS: Both = ['Bytes {0}; the picture has {1}, because there exact lambdas decide, and here rounding does.',
    'Bytes {0}; la imagen tiene {1}, porque allí deciden las lambdas exactas y aquí el redondeo.'];

/** Parts of objects, and why a lambda does not count, by the words of `literal` (`cli/literal/src/intersect.rs`). */
const PHRASES: Record<string, Both> = {
    'sphere': ['sphere', 'esfera'],
    'side': ['side', 'lado'],
    'upper base': ['upper base', 'base superior'],
    'lower base': ['lower base', 'base inferior'],
    '': ['is in range', 'está en el rango'],
    'it is below 1e-3': ['does not count: it is below 1e-3', 'no cuenta: es menor que 1e-3'],
    'it is outside of the radius': ["does not count: its point is farther from the base's centre than the radius",
        'no cuenta: su punto dista del centro de la base más que el radio'],
    'it is beyond the bases': ['does not count: its point is farther along the axis than half the height',
        'no cuenta: su punto dista a lo largo del eje más que la mitad de la altura'],
    'the smaller root counts': ["does not count: this object's smaller root is in range",
        'no cuenta: la raíz menor de este objeto está en el rango'],
    'it is not a number': ['is not a number, as if the ray is parallel to the axis',
        'no es un número, como si el rayo es paralelo al eje'],
    'the base is parallel to the ray': ['does not exist: the base is parallel to the ray',
        'no existe: la base es paralela al rayo'],
};

/** Parts of rows that are in several ones. */
const COLOUR: Both = ['colour', 'color'];
const END: Both = ['end', 'final'];
const NORMAL: Both = ['normal', 'normal'];
const VECTOR: Both = ['vector', 'vector'];
const ALONE: Both = ['{0}', '{0}'];
const SENDS: Both = ['sends a ray along {0}', 'envía un rayo en la dirección {0}'];

/** The rows of the table: what a row is about, and what it says. */
const ROWS = {
    offset: [['offset', 'desplazamiento'], ['x = {0}, y = {1}: numbers {2} and {3} of ray_rng_seed',
        'x = {0}, y = {1}: números {2} y {3} de ray_rng_seed']],
    target: [['Q', 'Q'], ALONE],
    ray: [['ray', 'rayo'], ['{0} of at most {1}: depth {2}', '{0} de {1} como máximo: profundidad {2}']],
    from: [['from', 'desde'], ALONE],
    along: [['along', 'dirección'], ALONE],
    candidate: [['', ''], ['{0}: lambda {1} {2}', '{0}: lambda {1} {2}']],
    beyond: [['', ''], ['{0}: lambda {1} {2}: {3} > {4}', '{0}: lambda {1} {2}: {3} > {4}']],
    missed: [['', ''], ['{0}: no root, the discriminant is negative', '{0}: sin raíz, el discriminante es negativo']],
    nearest: [['nearest', 'más cercano'], ['object {0}, {1}, at lambda {2}', 'objeto {0}, {1}, con lambda {2}']],
    point: [['point', 'punto'], ALONE],
    outward: [NORMAL, ['{0}, outward: the ray comes from outside', '{0}, hacia fuera: el rayo viene de fuera']],
    turned: [NORMAL, ['{0}, already turned round: the ray comes from inside',
        '{0}, ya invertida: el rayo viene de dentro']],
    side: [['', ''], ["A side's normal is not made a unit: its length is the radius.",
        'La normal de un lado no se hace unitaria: su longitud es el radio.']],
    draws: [['draws', 'sorteos'], ['{0}: {1} to {2} of material_rng_seed', '{0}: {1} a {2} de material_rng_seed']],
    toNormal: [VECTOR, ['{0} is added to the normal', '{0} se suma a la normal']],
    toReflected: [VECTOR, ['{0} is added to the reflected unit direction',
        '{0} se suma a la dirección reflejada unitaria']],
    interval: [['', ''], ['each in [-{0}, {0})', 'cada uno en [-{0}, {0})']],
    idle: [['', ''], ['diffusion 0: drawn all the same', 'difusión 0: se sortean igualmente']],
    enters: [["rho'", "rho'"], [
        "= {0} = 1 / {1}: the ray enters the object (\"hacia adentro\" in the rule is the ray's way, not the normal's)",
        '= {0} = 1 / {1}: el rayo entra en el objeto '
        + '(«hacia adentro» en la regla es el sentido del rayo, no el de la normal)']],
    leaves: [["rho'", "rho'"], ['= rho = {0}: the ray leaves the object ("hacia afuera" in the rule is the ray\'s way)',
        '= rho = {0}: el rayo sale del objeto («hacia afuera» en la regla es el sentido del rayo)']],
    reflected: [['', ''], ["cos with this normal {0}, sin {1}, rho' sin = {2} > 1: it is reflected",
        "cos con esta normal {0}, sen {1}, rho' sen = {2} > 1: se refleja"]],
    refracted: [['', ''], ["cos with this normal {0}, sin {1}, rho' sin = {2} <= 1: it is refracted",
        "cos con esta normal {0}, sen {1}, rho' sen = {2} <= 1: se refracta"]],
    matte: [['matte', 'mate'], SENDS],
    metal: [['metal', 'metal'], SENDS],
    refractive: [['refractive', 'refractante'], SENDS],
    reflectance: [COLOUR, ['of that ray is multiplied by the reflectance {0}',
        'de ese rayo se multiplica por la reflectancia {0}']],
    depth: [END, ['{0}, black: the depth is used up', '{0}, negro: la profundidad está agotada']],
    background: [END, ['{0}, the background along the last ray, which hits nothing',
        '{0}, el fondo en la dirección del último rayo, que no toca nada']],
    mixed: [['', ''], ['(1 - m) light + m dark, where m = (y of the ray\'s unit direction + 1) / 2 = {0}',
        '(1 - m) claro + m oscuro, con m = (y de la dirección unitaria + 1) / 2 = {0}']],
    color: [COLOUR, ['of the sample, times all reflectances: {0}', 'de la muestra, por todas las reflectancias: {0}']],
    more: [['…', '…'], ['Only the first {0} steps are shown.', 'Solo se muestran los {0} primeros pasos.']],
    counts: [['numbers', 'números'], ['Columns, rows, samples and random numbers count from 0, objects from 1.',
        'Columnas, filas, muestras y números aleatorios se cuentan desde 0, y objetos desde 1.']],
    window: [['window', 'ventana'], [
        'O {0}, dx {1}, dy {2}; Q = O + dx (column + x) + dy (row + y), where the statement prints P for O',
        'O {0}, dx {1}, dy {2}; Q = O + dx (columna + x) + dy (fila + y), donde el enunciado pone P en vez de O']],
    sky: [['background', 'fondo'], ['light {0}, dark {1}', 'claro {0}, oscuro {1}']],
    all: [['all samples', 'todas las muestras'], ['', '']],
    mean: [['mean', 'media'], ['{0} of all {1} samples; the field Sample shows another',
        '{0} de las {1} muestras; el campo Muestra enseña otra']],
    scaled: [['scaled', 'escalado'], ['{0} = 255 × mean^(1 / {1})', '{0} = 255 × media^(1 / {1})']],
    bytes: [['bytes', 'bytes'], ['{0}: truncated', '{0}: truncados']],
} satisfies Record<string, [about: Both, text: Both]>;

/** The rows that begin a part of the table. */
const HEADS: string[] = ['ray', 'all'];

/** Largest number of steps that are shown. Between mirrors, a path may have any number. */
const MOST_STEPS = 2000;

const at = (vector: number[]): string => `(${vector.join(', ')})`;

/** The view. */
export class ExplainView {
    readonly #table = element<HTMLTableElement>('explain-steps');
    readonly #inputs = ['column', 'row', 'sample'].map((name) => element<HTMLInputElement>(`explain-${name}`));
    readonly #cancel = element<HTMLButtonElement>('explain-cancel');
    /** The worker. Another question ends one that is busy, and takes a new one. The button is shown meanwhile. */
    #worker: Asked<Question, string> | null = null;
    #newest = 0;
    #clicked: Explained['place'] = null;
    #objects: Definition[] = [];

    constructor(private readonly find: () => Explained | null, private readonly goTo: (line: number) => void,
        private readonly beside: (column: number, row: number, picture: Rgb) => { name: string; bytes: number[] } | null) {
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

    /** Explains the chosen pixel of the picture, which may be new. A click in the picture may have chosen another one. */
    async renew(): Promise<void> {
        const own = this.#stop();
        const found = this.find();
        this.#table.replaceChildren();
        write(element('explain-said'), () => (found ? say('busy') : ofLanguage(WAITS)));
        if (!found) {
            return;
        }
        const { texts, pixels, vectors, place } = found;
        const { width, height, data } = pixels;
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
            const life = JSON.parse(answer) as Life;
            this.#cancel.hidden = true;
            if (life.message) {
                throw new Error(life.message);
            }
            limited('explain-sample', 'sample', life.count, 0);
            this.#objects = definitions(texts.scene).objects;
            const start = 3 * (row * width + column);
            this.#show(life, Array.from(data.subarray(start, start + 3)), this.beside(column, row, pixels));
        } catch (error) {
            if (own === this.#newest) {
                this.#cancel.hidden = true;
                write(element('explain-said'), () => messageOf(error));
            }
        }
    }

    #show(
        { samples, count, window, background, mean, gamma, scaled, bytes }: Life, picture: number[],
        other: ReturnType<typeof this.beside>,
    ): void {
        const words = String(bytes) === String(picture) ? SAME : DIFFERS;
        write(element('explain-said'), () => filled(words, bytes.join(' '), picture.join(' '))
            + (other ? filled(BESIDE, other.name, other.bytes.join(' ')) : ''));
        element('explain-said').style.setProperty('--color', `rgb(${bytes})`);
        const depth = samples.find((step) => step.event === 'ray')?.depth ?? 0;
        this.#add('counts');
        this.#add('window', ...window.map(at));
        this.#add('sky', ...background.map(at));
        samples.slice(0, MOST_STEPS).forEach((step, index) => this.#tell(step, samples[index - 1], depth));
        samples.length > MOST_STEPS && this.#add('more', MOST_STEPS);
        this.#add('all');
        this.#add('mean', at(mean), count);
        this.#add('scaled', at(scaled), String(gamma));
        this.#add('bytes', bytes.join(' '));
    }

    /** Adds the rows of a step that is after `before`. `depth` is the number of rays that a sample may send. */
    #tell(step: Step, before: Step | undefined, depth: number): void {
        const part = PHRASES[step.part] ?? step.part;
        switch (step.event) {
            case 'sample': {
                const { place, offset } = step;
                offset.length > 0 && this.#add('offset', ...offset.map(String), place, place + 1);
                this.#add('target', at(step.target));
                break;
            }
            case 'ray':
                this.#add('ray', depth - step.depth + 1, depth, step.depth);
                this.#add('from', at(step.origin));
                this.#add('along', at(step.direction));
                break;
            case 'candidate': {
                const { object, fault, reach } = step;
                if (step.part === 'upper base' && !(before?.event === 'candidate' && before.object === object)) {
                    this.#link(object, this.#add('missed', PHRASES['side'] ?? ''));
                }
                const isBeyond = reach && ['it is outside of the radius', 'it is beyond the bases'].includes(fault);
                const values = [part, String(step.lambda ?? ''), PHRASES[fault] ?? fault];
                this.#link(object, isBeyond ? this.#add('beyond', ...values, ...reach.map(String))
                    : this.#add('candidate', ...values));
                break;
            }
            case 'hit': {
                const { draws, half, material, place, front, normal, direction, refraction } = step;
                this.#add('nearest', step.object, part, String(step.lambda));
                this.#add('point', at(step.point));
                this.#add(front ? 'outward' : 'turned', at(normal));
                step.part === 'side' && this.#add('side');
                if (draws.length > 0) {
                    this.#add('draws', draws.join(', '), place, place + draws.length - 1);
                    this.#add(half === 0 ? 'idle' : 'interval', String(half));
                }
                if (refraction) {
                    const { index, ratio, cos, sin, product, reflects } = refraction;
                    this.#add(front ? 'enters' : 'leaves', String(ratio), String(index));
                    this.#add(reflects ? 'reflected' : 'refracted', ...[cos, sin, product].map(String));
                } else {
                    this.#add(material === 'matte' ? 'toNormal' : 'toReflected', at(step.vector));
                }
                this.#add(material, at(direction));
                this.#add('reflectance', at(step.reflectance));
                break;
            }
            case 'end':
                this.#add(step.reason, at(step.end));
                step.m !== null && this.#add('mixed', String(step.m));
                this.#add('color', at(step.color));
        }
    }

    /** Adds a row, and returns the cell that says what the row is about. */
    #add(key: keyof typeof ROWS, ...values: (string | number | Both)[]): HTMLElement {
        const [about, text] = ROWS[key];
        const row = this.#table.insertRow();
        row.className = HEADS.includes(key) ? 'part' : '';
        const head = document.createElement('th');
        row.append(head);
        about[0] && write(head, () => ofLanguage(about));
        const told = () => values.map((value) => (typeof value === 'object' ? ofLanguage(value) : value));
        write(row.insertCell(), () => filled(text, ...told()));
        return head;
    }

    /** Makes a cell a link to the line of an object. */
    #link(object: number, cell: HTMLElement): void {
        const one = this.#objects[object - 1];
        one && cell.append(linkTo(one, () => objectName(one), this.goTo));
    }
}
