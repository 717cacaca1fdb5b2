"""Tests exact intersections, depth and normals against fractions."""

import unittest

import numpy as np
from exact import closest

import exact_renderer
from exact_renderer import Config, Scene

SHAPES = [
    ((0, 0, 0), 1),
    ((3, 0.1, 0.2), 0.7, (0.3, 2, -0.5)),
    ((0.1, -1000, 0.3), 998.5),
    ((-2.5, 0.5, 0), 0.25, (1e-3, 0, 0)),
]


def scene(shapes):
    made = Scene().matte("m", (1, 1, 1))
    for shape in shapes:
        (made.sphere if len(shape) == 2 else made.cylinder)(*shape, "m")
    return made


def grazing(count, distance, random):
    """Returns rays that touch the unit sphere around 0, up to their rounding."""
    u, v = random.normal(size=(2, count, 3))
    u /= np.linalg.norm(u, axis=1)[:, None]
    v -= np.sum(u * v, axis=1)[:, None] * u
    v /= np.linalg.norm(v, axis=1)[:, None]
    return -distance * u, np.sqrt(distance**2 - 1) * u + v


class Intersections(unittest.TestCase):
    def compare(self, origins, directions, shapes):
        hit, distance, normal, part = exact_renderer.intersect(origins, directions, scene(shapes))
        for index in range(len(origins)):
            expected = closest(origins[index], directions[index], shapes)
            self.assertEqual((hit[index], part[index]), (expected[0], expected[2]))
            if expected[0] < 0:
                self.assertTrue(np.isnan([distance[index], *normal[index]]).all())
                continue
            self.assertLess(abs(distance[index] / float(expected[1]) - 1), 1e-9)
            self.assertAlmostEqual(np.linalg.norm(normal[index]), 1, places=4)
            point = origins[index] + distance[index] * directions[index]
            self.assertGreater(normal[index] @ (point - shapes[hit[index]][0]), 0, "it points out of the object")
        return hit

    def test_closest_hits_are_those_of_fractions(self):
        random = np.random.default_rng(1)
        # These scenes get different structures: a few objects, and many.
        many = SHAPES + [(tuple(random.uniform(-9, 9, 3)), random.uniform(0.2, 1)) for _ in range(200)]
        for shapes, count in ((SHAPES, 400), (many, 100)):
            origins = random.uniform(-6, 6, (count, 3))
            hit = self.compare(origins, random.uniform(-3, 3, (count, 3)) - origins, shapes)
            self.assertGreater(len(set(hit)), 4)

    def test_grazing_rays_are_decided_exactly(self):
        random = np.random.default_rng(2)
        for distance in (2, 1e3, 1e6):
            origins, directions = grazing(300, distance, random)
            hit = self.compare(origins, directions, SHAPES[:1])
            self.assertTrue(0.1 < np.mean(hit == 0) < 0.9, "about half of them hit")

    def test_extreme_rays_are_decided_exactly(self):
        origins = [(0, 0, -5)] * 6 + [(0, 0, -1e10), (0, 0, 1e-3 - 1), (0, 0, 0)]
        directions = [(0, 0, z) for z in (1e-200, 1e-9, 1e9, 1e150, 0, -1, 1e10, -1)] + [(1e-5, 0, 0)]
        self.compare(np.array(origins), np.array(directions), SHAPES[:1])
        self.compare(np.array(origins), np.array(directions), SHAPES[:1] + [((9, i, 9), 0.4) for i in range(300)])

    def test_arrays_may_have_any_order_and_type_that_keeps_the_numbers(self):
        origins = np.array([[0, 0, -5], [0, 3, -5]])
        expected = exact_renderer.intersect(origins, [[0, 0, 1], [0, 0, 1]], scene(SHAPES[:1]))
        directions = np.ones((3, 4), np.float32)[:, ::2] * [[0], [0], [1]]
        for one, other in zip(exact_renderer.intersect(origins, directions.T, scene(SHAPES[:1])), expected):
            np.testing.assert_array_equal(one, other)
        self.assertEqual(list(expected[0]), [0, -1])
        np.testing.assert_array_equal(expected[1], [4, np.nan])
        # Numbers at an odd address, in the byte order of another machine, and a large whole number.
        odd = np.frombuffer(bytes(1) + origins.astype(float).tobytes(), "f8", 6, 1).reshape(2, 3)
        self.assertFalse(odd.flags.aligned)
        for same in (odd, origins.astype(">f8"), origins.astype(">i8"), np.asfortranarray(origins), origins.tolist()):
            found = exact_renderer.intersect(same, [[0, 0, 1], [0, 0, 1]], scene(SHAPES[:1]))
            for one, other in zip(found, expected):
                np.testing.assert_array_equal(one, other)
        exact_renderer.intersect(np.full((1, 3), 2**60), np.full((1, 3), np.uint64(2**63)), Scene())
        empty = exact_renderer.intersect(np.empty((0, 3)), np.empty((0, 3)), Scene())
        self.assertEqual([array.shape for array in empty], [(0,), (0,), (0, 3), (0,)])

    def test_other_arrays_are_refused(self):
        good = np.ones((4, 3))
        for bad, error, words in (
            (np.ones((4, 2)), ValueError, r"directions has the shape \(4, 2\), and \(n, 3\) is needed"),
            (np.ones(3), ValueError, "has the shape"),
            (np.ones((5, 3)), ValueError, "4 origins and 5 directions"),
            (good * np.inf, ValueError, "directions has a number that is not finite"),
            (good * 1j, TypeError, "complex128"),
            (np.full((4, 3), 2**53 + 1), ValueError, "directions has a whole number that float64 cannot hold"),
            (np.full((4, 3), -(2**60) - 1, ">i8"), ValueError, "float64 cannot hold"),
            (np.full((4, 3), 2**64 - 1, "u8"), ValueError, "float64 cannot hold"),
            (np.full((4, 3), 2**70, object), TypeError, "Cannot cast"),
            ([["a"] * 3] * 4, TypeError, "Cannot cast"),
        ):
            with self.assertRaisesRegex(error, words):
                exact_renderer.intersect(good, bad, Scene())

    def test_depth_and_normals_are_those_of_the_middles_of_pixels(self):
        # From (0, 0, -10) to 0 at 90 degrees, the window is 20 high, and its 3 x 3 pixels have the size 20 / 3.
        config = Config(image_width=3, aspect_ratio=(1, 1))
        offsets = [-20 / 3, 0, 20 / 3]
        directions = np.array([[-x, -y, 10] for y in offsets for x in offsets])
        hit, distance, normal, _ = exact_renderer.intersect([(0, 0, -10)] * 9, directions, scene(SHAPES))
        self.assertGreater(len(set(hit)), 2)
        lengths = np.linalg.norm(directions, axis=1)
        np.testing.assert_allclose(exact_renderer.depth(config, scene(SHAPES)).ravel(), distance * lengths, rtol=1e-9)
        np.testing.assert_allclose(exact_renderer.normals(config, scene(SHAPES)).reshape(9, 3), normal, atol=1e-9)
