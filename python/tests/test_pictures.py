"""Tests pictures, scenes and configurations, and their errors."""

import copy
import hashlib
import itertools
import multiprocessing
import pathlib
import pickle
import unittest

import numpy as np

import exact_renderer
from exact_renderer import Config, Scene

CASES = pathlib.Path(__file__).parents[2] / "tests" / "cases"
SMALL = Config(image_width=20, aspect_ratio=(4, 3), samples_per_pixel=3)
TEXT = """matte: grey .5 .5 .5
metal: mirror .9 .8 .7 .05
refractive: glass 1.5
sphere: 0 0 0 1 glass
cylinder: 2 0 1 .5 0 2 0 mirror
sphere: 0 -101 0 100 grey
"""


def made():
    return (
        Scene()
        .matte("grey", (0.5, 0.5, 0.5))
        .metal("mirror", np.array([0.9, 0.8, 0.7]), 0.05)
        .refractive("glass", 1.5)
        .sphere((0, 0, 0), np.int64(1), "glass")
        .cylinder([2, 0, 1], 0.5, (0, 2, 0), "mirror")
        .sphere((0, -101, 0), 100, "grey")
    )


class Pictures(unittest.TestCase):
    def test_digests_are_those_of_the_independent_program(self):
        lines = (CASES / "SHA256SUMS").read_text().splitlines()[1:]
        self.assertGreater(len(lines), 30)
        for line in lines:
            digest, name = line.split()
            scatter, case = name.removesuffix(".ppm").split("/")
            config = Config.parse((CASES / case / "config.txt").read_bytes())
            scene = Scene.parse((CASES / case / "scene.txt").read_bytes())
            picture = exact_renderer.render(config, scene, scatter)
            height, width, _ = picture.shape
            pixels = "".join("%d %d %d\n" % tuple(pixel) for pixel in picture.reshape(-1, 3).tolist())
            ppm = f"P3\n{width} {height}\n255\n{pixels}"
            self.assertEqual(hashlib.sha256(ppm.encode()).hexdigest(), digest, name)

    def test_bytes_are_the_means_after_gamma_correction(self):
        picture = exact_renderer.render(SMALL, made())
        means = exact_renderer.render(SMALL, made(), linear=True)
        self.assertEqual((picture.shape, picture.dtype), ((15, 20, 3), np.uint8))
        self.assertEqual((means.shape, means.dtype), ((15, 20, 3), np.float64))
        self.assertLessEqual(np.abs(np.floor(255 * means ** (1 / 2.2)) - picture).max(), 1)

    def test_values_of_python_are_those_of_a_text(self):
        self.assertEqual(made(), Scene.parse(TEXT))
        self.assertNotEqual(made(), Scene.parse(TEXT.encode()).sphere((0, 0, 0), 1, "grey"))
        text = "image_width: 20\naspect_ratio: 4 3\nsamples_per_pixel: 3\n"
        self.assertEqual(SMALL, Config.parse(text))
        self.assertEqual(SMALL.replace(gamma=1), Config.parse(text + "gamma: 1"))
        self.assertEqual(Config(gamma=np.float32(0.1)), Config(gamma=0.10000000149011612))


class Values(unittest.TestCase):
    def test_a_copy_a_pickle_and_what_repr_shows_are_equal(self):
        config = SMALL.replace(camera_position=(0.1, -1e-300, 1e300), ray_rng_seed=2**64 - 1)
        names = {"Config": Config, "Scene": Scene}
        for value in (config, Config(), made(), Scene()):
            copies = [copy.copy(value), copy.deepcopy(value), eval(repr(value), names)]
            copies += [pickle.loads(pickle.dumps(value, protocol)) for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1)]
            for one in copies:
                self.assertEqual(one, value)
        # A copy of a scene is another one.
        scene = made()
        other = copy.copy(scene).sphere((0, 0, 0), 1, "grey")
        self.assertEqual((len(scene), len(other)), (6, 7))

    def test_another_process_renders(self):
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            picture = pool.apply_async(exact_renderer.render, (SMALL, made())).get(60)
        np.testing.assert_array_equal(picture, exact_renderer.render(SMALL, made()))

    def test_a_configuration_has_its_keys(self):
        self.assertEqual((SMALL.image_width, SMALL.aspect_ratio, SMALL.gamma), (20, (4, 3), 2.2))
        self.assertEqual(Config().camera_position, (0, 0, -10))
        keys = [name for name in dir(Config) if not name.startswith("_") and name not in ("parse", "replace")]
        self.assertEqual((len(keys), Config(**{key: getattr(SMALL, key) for key in keys})), (13, SMALL))
        self.assertIn("image_width=20, gamma=2.2, camera_position=(0.0, 0.0, -10.0)", repr(SMALL))

    def test_a_scene_is_a_sequence_of_its_entries(self):
        scene = made()
        entries = list(scene)
        self.assertEqual(entries[0], ("matte", "grey", (0.5, 0.5, 0.5)))
        self.assertEqual(entries[1:3], [("metal", "mirror", (0.9, 0.8, 0.7), 0.05), ("refractive", "glass", 1.5)])
        self.assertEqual(entries[4], ("cylinder", (2, 0, 1), 0.5, (0, 2, 0), "mirror"))
        self.assertEqual((scene[-1], scene[3:5]), (entries[5], entries[3:5]))
        self.assertEqual((Scene(entries), Scene(iter(scene))), (scene, scene))
        self.assertRaises(IndexError, lambda: scene[6])
        self.assertRaisesRegex(ValueError, "is no entry of a scene", Scene, [("cone", (0, 0, 0))])
        self.assertRaisesRegex(exact_renderer.Error, "no material", Scene, entries[3:])


class Errors(unittest.TestCase):
    def check(self, call, place, *words):
        with self.assertRaises(exact_renderer.Error) as raised:
            call()
        error = raised.exception
        self.assertEqual((error.line, error.column), place, error)
        for word in words:
            self.assertIn(word, error.message)
        self.assertTrue(str(error).endswith(error.message))

    def test_errors_have_their_place_and_a_remedy(self):
        self.check(lambda: Config.parse("gamma: 1\r\n\nimage_width: x"), (3, 14), "[x] is not a whole number above 0")
        self.check(lambda: Scene.parse("matte: \xe4 1 1 1\nsphere: 0 0 0 1 b"), (2, 17), "no material [b]")
        self.check(lambda: Scene.parse(b"matte: \xff 1 1 2"), (1, 14), "[2] is not a number from 0 to 1")
        self.check(lambda: Config(gama=1), (1, 1), "did you mean [gamma:]?")
        self.check(lambda: Config(gamma=1, image_width=2.0), (2, 14), "image_width: 2")
        self.check(lambda: Config(gamma=float("nan")), (1, 8), "[NaN] is not a number above 0")
        self.check(lambda: Config(max_depth=10**30), (1, 12), "at most 18446744073709551615")
        self.check(lambda: made().sphere((0, 0, 0), -1, "grey"), (7, 15), "[-1] is not a number above 0")
        self.check(lambda: Config(camera_north=itertools.count()), (1, 21), "more than its 3 values")
        self.check(lambda: made().sphere((0, 0, 0), 1, "gray"), (7, 17), "did you mean [grey]?")
        self.check(lambda: made().matte("grey", (1, 1, 1)), (7, 8), "already defined")
        self.check(lambda: made().matte("", (1, 1, 1)), (7, 14), "name before the numbers is missing")
        same = SMALL.replace(camera_target=(0, 0, -10))
        self.check(lambda: exact_renderer.render(same, made()), (None, None), "camera_target")
        huge = SMALL.replace(image_width=2**40)
        for call in (exact_renderer.render, exact_renderer.depth, exact_renderer.normals):
            self.check(lambda: call(huge, made()), (None, None), "at most 1073741824")

        self.assertRaisesRegex(ValueError, "three numbers", made().sphere, (0, 0), (0, 1), "grey")

    def test_other_types_are_refused(self):
        for call in (
            lambda: Config.parse(3),
            lambda: Config(gamma="1"),
            lambda: Config(gamma=None),
            lambda: Config(camera_position=(0, 0, "1")),
            lambda: made().sphere((0, 0, 0), [1], "grey"),
            lambda: made().sphere(0, 1, "grey"),
            lambda: made().sphere((0, 0, 0), 1, 2),
            lambda: exact_renderer.render(SMALL, TEXT),
        ):
            self.assertRaises(TypeError, call)
        with self.assertRaisesRegex(ValueError, "choose statement, published or deterministic"):
            exact_renderer.render(SMALL, made(), "none")
