// Two plans of the scene with the way of a ray: from above (x to the right, z downwards), and against z (x to the right,
// y upwards).
import type { Facts, ShapeOf } from './preparer';
import { say, write, type Key } from './words';

const SVG = 'http://www.w3.org/2000/svg';

/** An element of a drawing. */
function draw(name: string, attributes: Record<string, string | number>): SVGElement {
    const element = document.createElementNS(SVG, name);
    Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, String(value)));
    return element;
}

/** The axes of a plan: the number of the axis to the right, that of the vertical axis, and 1 if that axis points down. */
type Axes = readonly [right: number, vertical: number, sign: 1 | -1];

/** The outline of an object, seen along the axis that a plan does not have. */
function outline([kind, center, radius, axis]: ShapeOf, [right, vertical, sign]: Axes): SVGElement {
    const [x, y] = [center[right] ?? 0, sign * (center[vertical] ?? 0)];
    if (kind === 'sphere') {
        return draw('circle', { cx: x, cy: y, r: radius });
    }
    // Both caps are ellipses, and the outline is the hull of them: a thick line between their centres is near to it.
    const [dx, dy] = [axis[right] ?? 0, sign * (axis[vertical] ?? 0)];
    if (Math.hypot(dx, dy) < radius / 100) {
        return draw('circle', { cx: x, cy: y, r: radius });
    }
    const length = Math.hypot(dx, dy);
    const [nx, ny] = [(-dy / length) * radius, (dx / length) * radius];
    const corners = [[-1, 1], [1, 1], [1, -1], [-1, -1]].map(([along = 0, across = 0]) =>
        [x + along * dx + across * nx, y + along * dy + across * ny]);
    return draw('polygon', { points: corners.map((corner) => corner.join(',')).join(' ') });
}

/** Largest number of objects in a plan. */
const MAX_OBJECTS = 2000;

function view(facts: Facts, paths: readonly Path[], axes: Axes, key: Key): SVGElement {
    const [right, vertical, sign] = axes;
    // Objects that are much larger than the distance to the target, such as the ground, do not count for the frame.
    const reach = 3 * Math.hypot(...facts.position.map((value, axis) => value - (facts.target[axis] ?? 0)));
    const points = paths.flat();
    const near = facts.shapes.filter(([, , radius]) => radius < reach).slice(0, MAX_OBJECTS);
    const [xs, ys] = [right, vertical].map((axis) => [
        ...points.map((point) => point[axis] ?? 0),
        facts.position[axis] ?? 0,
        ...near.flatMap(([, center, radius]) => [(center[axis] ?? 0) - radius, (center[axis] ?? 0) + radius]),
    ]);
    const limits = (values: number[] = [0]): [number, number] => [Math.min(...values), Math.max(...values)];
    const [left, farRight] = limits(xs);
    const [low, high] = limits(ys);
    const size = Math.max(farRight - left, high - low, 1) * 1.25;
    const [middleX, middleY] = [(left + farRight) / 2, (low + high) / 2];
    const box = [middleX - size / 2, sign * middleY - size / 2, size, size];
    const svg = draw('svg', { viewBox: box.join(' '), role: 'img', 'aria-label': say(key), 'data-label': key });
    facts.shapes.slice(0, MAX_OBJECTS).forEach((shape) => svg.append(outline(shape, axes)));
    paths.forEach((path, number) => {
        const way = path.map((point) => `${point[right] ?? 0},${sign * (point[vertical] ?? 0)}`).join(' ');
        svg.append(draw('polyline', { points: way, class: number === 0 ? 'rust' : 'wgsl' }));
        path.filter((_, index) => index % 2 === 1).forEach((point) => {
            const [cx, cy] = [point[right] ?? 0, sign * (point[vertical] ?? 0)];
            svg.append(draw('circle', { class: 'hit', cx, cy, r: size / 90 }));
        });
    });
    const [cameraX, cameraY] = [facts.position[right] ?? 0, sign * (facts.position[vertical] ?? 0)];
    svg.append(draw('circle', { class: 'camera', cx: cameraX, cy: cameraY, r: size / 60 }));
    return svg;
}

/** The starts and ends of the rays of a path. */
type Path = readonly number[][];

/** Returns both views of the scene with the path by Rust and, if there is one, that by WGSL. */
export function plan(facts: Facts, rust: Path, wgsl: Path | null): DocumentFragment {
    const both = document.createDocumentFragment();
    const isSame = JSON.stringify(rust) === JSON.stringify(wgsl);
    for (const [axes, key] of [[[0, 2, 1], 'planAbove'], [[0, 1, -1], 'planFront']] as const) {
        const figure = document.createElement('figure');
        const caption = document.createElement('figcaption');
        write(caption, () => `${say(key)}; ${say(!wgsl ? 'planRust' : isSame ? 'planSame' : 'planPaths')}`);
        figure.append(view(facts, !wgsl || isSame ? [rust] : [rust, wgsl], axes, key), caption);
        both.append(figure);
    }
    return both;
}
