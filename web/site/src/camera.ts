// A camera that turns around its target, moves with it, and comes closer. It is printed as lines of a configuration.
import type { ShapeOf, Vector } from './preparer';

const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scale = (a: Vector, factor: number): Vector => [a[0] * factor, a[1] * factor, a[2] * factor];
const subtract = (a: Vector, b: Vector): Vector => add(a, scale(b, -1));
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const length = (a: Vector): number => Math.hypot(...a);
const unit = (a: Vector): Vector => scale(a, 1 / (length(a) || 1));
const cross = (a: Vector, b: Vector): Vector =>
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** The smallest angle between the direction of view and north, in radians. At 0 the picture would have no up. */
const LEAST_ANGLE = 0.02;

/** Turns `vector` by `angle` around the unit vector `axis` (the formula of Rodrigues). */
function turn(vector: Vector, axis: Vector, angle: number): Vector {
    const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
    const along = scale(axis, dot(axis, vector) * (1 - cosine));
    return add(add(scale(vector, cosine), scale(cross(axis, vector), sine)), along);
}

/** Returns a number with at most six significant digits, which is what the line has. */
const short = (number: number): number => Number(number.toPrecision(6));
const roundedVector = (vector: Vector): Vector => [short(vector[0]), short(vector[1]), short(vector[2])];

/** The place and the direction of a camera, in the units of the scene. */
export interface Camera {
    position: Vector;
    target: Vector;
    north: Vector;
}

/** Turns the camera around its target: `right` and `up` are angles in radians. */
export function orbit({ position, target, north }: Camera, right: number, up: number): Camera {
    const axis = unit(north);
    let arm = turn(subtract(position, target), axis, -right);
    const side = unit(cross(axis, arm));
    const angle = Math.acos(Math.min(1, Math.max(-1, dot(unit(arm), axis))));
    const wanted = Math.min(Math.PI - LEAST_ANGLE, Math.max(LEAST_ANGLE, angle - up));
    arm = turn(arm, side, wanted - angle);
    return { position: add(target, arm), target, north };
}

/** Moves the camera and its target. `right` and `up` are parts of the distance between them. */
export function pan({ position, target, north }: Camera, right: number, up: number): Camera {
    const arm = subtract(position, target);
    const side = unit(cross(unit(north), arm));
    const above = unit(cross(arm, side));
    const move = scale(add(scale(side, right), scale(above, up)), length(arm));
    return { position: add(position, move), target: add(target, move), north };
}

/** Multiplies the distance of the camera from its target. */
export function zoom({ position, target, north }: Camera, factor: number): Camera {
    return { position: add(target, scale(subtract(position, target), factor)), target, north };
}

/** Whether a point is inside an object. */
export function isInside(point: Vector, [kind, center, radius, axis]: ShapeOf): boolean {
    const arm = subtract(point, center);
    const along = dot(arm, unit(axis));
    return kind === 'sphere' ? length(arm) < radius
        : Math.abs(along) < length(axis) && length(subtract(arm, scale(unit(axis), along))) < radius;
}

/**
 * Returns where the axes of the scene point in the picture: for each of x, y and z the letter of the nearest direction,
 * which is right (r), left (l), up (u), down (d), away (a) or near (n).
 */
export function axes({ position, target, north }: Camera): string[] {
    const back = unit(subtract(position, target));
    const right = unit(cross(north, back));
    const parts = [right, cross(back, right), back];
    return [0, 1, 2].map((axis) => {
        const along = parts.map((part) => part[axis] ?? 0);
        const nearest = along.reduce((best, one, index) => (Math.abs(one) > Math.abs(along[best] ?? 0) ? index : best), 0);
        return ['rl', 'ud', 'na'][nearest]?.[(along[nearest] ?? 0) > 0 ? 0 : 1] ?? '';
    });
}

/** Returns the lines of a configuration that describe the camera with all digits. */
export function lines({ position, target, north }: Camera): [key: string, value: string][] {
    return [['camera_position:', position.join(' ')], ['camera_target:', target.join(' ')], ['camera_north:', north.join(' ')]];
}

/** Returns the camera with rounded vectors. A vector of `start`, the camera before it was moved, keeps all digits. */
export function rounded({ position, target, north }: Camera, start: Camera): Camera {
    const isSame = (one: Vector, other: Vector) => one.every((number, axis) => number === other[axis]);
    const of = (vector: Vector, old: Vector) => (isSame(vector, old) ? vector : roundedVector(vector));
    return { position: of(position, start.position), target: of(target, start.target), north: of(north, start.north) };
}

/** Returns a configuration with the lines of the camera. They replace the last lines with their keys, or are added. */
export function taken(config: string, camera: Camera): string {
    let rows = config.split('\n');
    for (const [key, value] of lines(camera)) {
        const isKey = (row: string) => row.trim().split(/\s+/)[0] === key;
        const place = rows.findLastIndex(isKey);
        if (place >= 0) {
            rows = rows.with(place, `${key} ${value}`);
        } else {
            const end = rows.at(-1) === '' ? rows.length - 1 : rows.length;
            rows.splice(end, 0, `${key} ${value}`);
        }
    }
    return rows.join('\n');
}
