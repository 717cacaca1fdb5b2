"""Intersections by fractions, which have no rounding errors. They share no code with the library."""

from decimal import Decimal, localcontext
from fractions import Fraction


def dot(one, other):
    return sum(a * b for a, b in zip(one, other))


def roots(a, h, c):
    """Returns the real roots of a x^2 + 2 h x + c, to 90 digits. The sign of the discriminant is exact."""
    square = h * h - a * c
    if a == 0 or square < 0:
        return []
    with localcontext() as context:
        context.prec = 100
        root = Fraction((Decimal(square.numerator) / Decimal(square.denominator)).sqrt())
    return [(-h - root) / a, (-h + root) / a]


def sphere(origin, direction, center, radius):
    """Returns pairs of lambda and part: all hits of the whole line."""
    r = [o - c for o, c in zip(origin, center)]
    found = roots(dot(direction, direction), dot(direction, r), dot(r, r) - radius * radius)
    return [(x, 0) for x in found]


def cylinder(origin, direction, center, radius, axis):
    """Returns pairs of lambda and part: all hits of the whole line. `axis` is as long as the cylinder is high."""
    r = [o - c for o, c in zip(origin, center)]
    length = dot(axis, axis)
    flat = lambda v: [x - dot(v, axis) * a / length for x, a in zip(v, axis)]
    at = lambda x: [a + x * b for a, b in zip(r, direction)]
    d, p = flat(direction), flat(r)
    side = roots(dot(d, d), dot(d, p), dot(p, p) - radius * radius)
    hits = [(x, 0) for x in side if abs(dot(at(x), axis)) * 2 <= length]
    if dot(direction, axis) != 0:
        for part, sign in ((1, 1), (2, -1)):
            x = (sign * length / Fraction(2) - dot(r, axis)) / dot(direction, axis)
            if dot(flat(at(x)), flat(at(x))) <= radius * radius:
                hits.append((x, part))
    return hits


def closest(origin, direction, objects):
    """Returns object, lambda and part of the closest hit with a lambda of at least 0.001, or (-1, None, -1)."""
    exactly = lambda value: Fraction(value) if isinstance(value, (int, float)) else [Fraction(float(x)) for x in value]
    origin, direction, best = exactly(origin), exactly(direction), (-1, None, -1)
    for index, shape in enumerate(objects):
        function = sphere if len(shape) == 2 else cylinder
        for x, part in function(origin, direction, *map(exactly, shape)):
            if x >= Fraction(1, 1000) and (best[1] is None or x < best[1]):
                best = (index, x, part)
    return best
