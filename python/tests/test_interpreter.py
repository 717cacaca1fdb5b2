"""Tests how the module works with the interpreter: threads, Ctrl-C and the notebook."""

import importlib.metadata
import json
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

import exact_renderer
from exact_renderer import Config, Scene

# A picture that takes hours, and within one row.
ENDLESS = "exact_renderer.Config(image_width=1, aspect_ratio=(1, 1), samples_per_pixel=10**15)"
OBJECTS = 'exact_renderer.Scene().matte("m", (1, 1, 1)).sphere((0, 0, 0), 1, "m")'


class Interpreter(unittest.TestCase):
    def test_the_version_is_that_of_the_project(self):
        manifest = (pathlib.Path(__file__).parents[2] / "Cargo.toml").read_text()
        self.assertIn(f'\nversion = "{importlib.metadata.version("exact_renderer")}"\n', manifest)

    def test_other_threads_go_on_while_a_picture_is_rendered(self):
        # The other thread needs the lock for each of its steps, and the picture takes some 0.5 s.
        config, scene = Config(image_width=300, samples_per_pixel=10_000), eval(OBJECTS)
        thread = threading.Thread(target=exact_renderer.render, args=(config, scene))
        start, steps = time.perf_counter(), 0
        thread.start()
        while thread.is_alive():
            time.sleep(0.001)
            steps += 1
        self.assertGreater(time.perf_counter() - start, 0.05, "the picture is too small for this test")
        self.assertGreater(steps, 20)

    def test_ctrl_c_ends_a_picture(self):
        for linear in (False, True):
            call = f"exact_renderer.render({ENDLESS}, {OBJECTS}, linear={linear})"
            command = [sys.executable, "-c", f"import exact_renderer; print(flush=True); {call}"]
            pipe = subprocess.PIPE
            with subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True) as process:
                process.stdout.readline()
                time.sleep(0.3)
                self.assertIsNone(process.poll())
                start = time.perf_counter()
                process.send_signal(signal.SIGINT)
                _, errors = process.communicate(timeout=30)
                self.assertLess(time.perf_counter() - start, 3)
                self.assertIn("KeyboardInterrupt", errors)

    def test_the_cells_of_the_notebook_run(self):
        path = pathlib.Path(__file__).parents[1] / "notebook.ipynb"
        cells = [cell for cell in json.loads(path.read_text())["cells"] if cell["cell_type"] == "code"]
        variables = {}
        for number, cell in enumerate(cells, 1):
            exec(compile("".join(cell["source"]), f"notebook.ipynb, code cell {number}", "exec"), variables)
        self.assertGreaterEqual(len(cells), 4)
        near, *_, far = variables["wrong"]
        self.assertTrue(near < 0.01 and 0.3 < far, "the plain formula guesses far away")
        errors = variables["errors"]
        self.assertLess(errors[-1], errors[0] / 2, "the error falls with the number of samples")
