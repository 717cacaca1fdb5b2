// A plan of the scene from above (x to the right, z upwards) and along z (y upwards), with the way of a ray.
import type { Facts, ShapeOf } from './preparer';
import { say } from './words';

const SVG = 'http://www.w3.org/2000/svg';

/** An element of a drawing. */
function draw(name: string, attributes: Record<string, string | number>): SVGElement {
    const element = document.createElementNS(SVG, name);
    Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, String(value)));
    return element;
}

/** The outline of an object, seen along the axis that is neither `right` nor `up`. */
function outline([kind, center, radius, axis]: ShapeOf, right: number, up: number): SVGElement {
    const [x, y] = [center[right] ?? 0, -(center[up] ?? 0)];
    if (kind === 'sphere') {
        return draw('circle', { cx: x, cy: y, r: radius });
    }
    // Both caps are ellipses, and the outline is the hull of them: a thick line between their centres is near to it.
    const [dx, dy] = [axis[right] ?? 0, -(axis[up] ?? 0)];
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

function view(facts: Facts, points: readonly number[][], right: number, up: number, name: string): SVGElement {
    // Objects that are much larger than the distance to the target, such as the ground, do not count for the frame.
    const reach = 3 * Math.hypot(...facts.position.map((value, axis) => value - (facts.target[axis] ?? 0)));
    const near = facts.shapes.filter(([, , radius]) => radius < reach).slice(0, MAX_OBJECTS);
    const [xs, ys] = [right, up].map((axis) => [
        ...points.map((point) => point[axis] ?? 0),
        facts.position[axis] ?? 0,
        ...near.flatMap(([, center, radius]) => [(center[axis] ?? 0) - radius, (center[axis] ?? 0) + radius]),
    ]);
    const limits = (values: number[] = [0]): [number, number] => [Math.min(...values), Math.max(...values)];
    const [left, farRight] = limits(xs);
    const [low, high] = limits(ys);
    const size = Math.max(farRight - left, high - low, 1) * 1.25;
    const [middleX, middleY] = [(left + farRight) / 2, (low + high) / 2];
    const box = [middleX - size / 2, -middleY - size / 2, size, size];
    const svg = draw('svg', { viewBox: box.join(' '), role: 'img', 'aria-label': name });
    facts.shapes.slice(0, MAX_OBJECTS).forEach((shape) => svg.append(outline(shape, right, up)));
    const way = points.map((point) => `${point[right] ?? 0},${-(point[up] ?? 0)}`).join(' ');
    svg.append(draw('polyline', { points: way }));
    points.forEach((point, index) => index % 2 === 1
        && svg.append(draw('circle', { class: 'hit', cx: point[right] ?? 0, cy: -(point[up] ?? 0), r: size / 90 })));
    const [cameraX, cameraY] = [facts.position[right] ?? 0, -(facts.position[up] ?? 0)];
    svg.append(draw('circle', { class: 'camera', cx: cameraX, cy: cameraY, r: size / 60 }));
    return svg;
}

/** Returns both views of the scene. `points` are the starts and ends of the rays. */
export function plan(facts: Facts, points: readonly number[][]): DocumentFragment {
    const both = document.createDocumentFragment();
    for (const [up, name] of [[2, say('planAbove')], [1, say('planFront')]] as const) {
        const figure = document.createElement('figure');
        const caption = document.createElement('figcaption');
        caption.textContent = name;
        figure.append(view(facts, points, 0, up, name), caption);
        both.append(figure);
    }
    return both;
}
