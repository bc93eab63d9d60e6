"""Pictures and windows, and errors for input that cannot be shown."""

import io
import os
import shutil
import subprocess
import sys
import tempfile
import time
import types
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import support
import talweg
from talweg import _scene, _windows

RED, BLUE = (200, 40, 30), (20, 80, 192)


def matplotlib_or_skip(test):
    try:
        import matplotlib  # pylint: disable=import-outside-toplevel
    except ImportError:
        test.skipTest("no matplotlib (Debian: python3-matplotlib)")
    return matplotlib


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills()
        cls.mesh = talweg.Mesh(cls.vertices, cls.faces)
        cls.result = cls.mesh.smooth(support.staircase())

    def setUp(self):
        matplotlib_or_skip(self)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def pixels(self, picture):
        from matplotlib import image  # pylint: disable=import-outside-toplevel
        source = io.BytesIO(picture) if isinstance(picture, bytes) else picture
        return np.rint(255 * image.imread(source)[:, :, :3]).astype(int)

    def near(self, pixels, color, within=60):
        return np.abs(pixels - color).max(axis=2) < within

    def test_in_a_notebook(self):
        pixels = self.pixels(self.result._repr_png_())  # pylint: disable=protected-access
        self.assertEqual(pixels.shape, (600, 800, 3))
        middle = pixels[:520]  # without the legend
        self.assertGreater(self.near(middle, RED).sum(), 50)
        self.assertGreater(self.near(middle, BLUE).sum(), 300)

    def test_lines_are_where_the_curve_is(self):
        camera = _scene.scene(self.mesh, self.result.curve, None, None, 1, None, (400, 300)).camera
        self.assertIsNone(talweg.show(self.mesh, self.result.curve, file=self.folder / "a.png",
                                      size=(400, 300)))
        pixels = self.pixels(self.folder / "a.png")
        self.assertEqual(pixels.shape, (300, 400, 3))
        blue = self.near(pixels, BLUE, 40)
        at = np.rint(camera.project(self.result.curve.positions)[:, :2]).astype(int)
        self.assertTrue(blue[at[:, 1], at[:, 0]].mean() > 0.95)
        away = np.linalg.norm(np.argwhere(blue)[:, None, ::-1] - at[None], axis=2).min(axis=1)
        self.assertLess(away.max(), 5)

    def test_formats_and_results(self):
        for name, begin in (("a.png", b"\x89PNG"), ("a.svg", b"<?xml"), ("a.pdf", b"%PDF")):
            self.result.show(file=self.folder / name, size=(160, 120))
            self.assertTrue((self.folder / name).read_bytes().startswith(begin), name)
        self.result.show(file=str(self.folder / "b.png"), size=(160, 120))
        talweg.show(self.mesh, self.result, file=self.folder / "c.png", size=(160, 120))
        pngs = [(self.folder / name).read_bytes() for name in ("a.png", "b.png", "c.png")]
        self.assertEqual(len(set(pngs)), 1)

    def test_into_axes(self):
        from matplotlib.figure import Figure  # pylint: disable=import-outside-toplevel
        figure = Figure()
        axes = figure.add_subplot()
        loop = talweg.draw((self.vertices, self.faces), [1220, 1240, 2440, 2420], closed=True)
        self.assertIs(talweg.show(self.mesh, {"route": self.result.curve, "field": [loop]},
                                  axes=axes, unit="m"), axes)
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()],
                         ["route", "field"])
        self.assertIn(" m", [text.get_text()[-2:] for text in axes.texts])

    def test_meshes_that_cannot_be_worked_on(self):
        broken = np.vstack([self.faces, self.faces[:1], [[0, 0, 0]]])
        with self.assertRaises(talweg.BadMesh):
            talweg.Mesh(self.vertices, broken)
        talweg.show((self.vertices, broken), file=self.folder / "a.png", size=(80, 60))
        holes = self.vertices.copy()
        holes[500] = np.nan
        talweg.show((holes, self.faces), file=self.folder / "b.png", size=(80, 60))
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_colors(self):
        halves = (np.arange(len(self.faces)) < len(self.faces) // 2).astype(int)
        mesh = talweg.Mesh(self.vertices, self.faces, face_attributes={"half": halves},
                           vertex_attributes={"height": self.vertices[:, 2]})
        pictures = {}
        for name, colors in (
                ("plain", None), ("label", "half"), ("same", halves), ("height", "height"),
                ("bytes", np.full((len(self.vertices), 3), [255, 0, 0], np.uint8)),
                ("real", np.full((len(self.vertices), 4), [1.0, 0, 0, 1]))):
            talweg.show(mesh, colors=colors, file=self.folder / "a.png", size=(160, 120))
            pictures[name] = self.pixels(self.folder / "a.png")
        np.testing.assert_array_equal(pictures["label"], pictures["same"])
        np.testing.assert_array_equal(pictures["bytes"], pictures["real"])
        red = pictures["bytes"]
        self.assertGreater(((red[:, :, 0] > 90) & (red[:, :, 1:].max(axis=2) < 90)).mean(), 0.3)
        for name in ("label", "height", "bytes"):
            self.assertGreater(np.abs(pictures[name] - pictures["plain"]).max(), 60, name)
        gaps = self.vertices[:, 2].copy()
        gaps[100:200] = np.inf
        talweg.show(mesh, colors=gaps, file=self.folder / "b.png", size=(160, 120))

    def test_refused(self):
        mesh, curve = self.mesh, self.result.curve
        n = len(self.vertices)
        for why, error, how in (
                ("view must be a direction", talweg.BadUsage, {"view": (0, 0, 0)}),
                ("view must be a direction.*'front'", talweg.BadUsage, {"view": "front"}),
                ("up must be a direction", talweg.BadUsage, {"up": (0, np.nan, 1)}),
                ("zoom must be", talweg.BadUsage, {"zoom": 0}),
                ("size must be", talweg.BadUsage, {"size": (0, 100)}),
                ("size must be", talweg.BadUsage, {"size": 100}),
                ("engine must be one of", talweg.BadUsage, {"engine": "opengl"}),
                ("no attribute label.*none", talweg.BadUsage, {"colors": "label"}),
                (f"colors must be .* {n} vertices", talweg.BadUsage, {"colors": np.zeros(n + 1)}),
                ("colors must be", talweg.BadUsage, {"colors": 3}),
                (r"a\.xyz: pictures end in .*\.png", talweg.BadUsage, {"file": "a.xyz"}),
                ("nowhere/a.png cannot be written", talweg.BadFile, {"file": "nowhere/a.png"})):
            with self.subTest(why), self.assertRaisesRegex(error, why):
                talweg.show(mesh, curve, **{"file": self.folder / "a.png", **how})
        for given, error, why in (
                ([1, n], talweg.BadCurve, f"mesh of {n} vertices"),
                (talweg.Curve(faces=[len(self.faces)], barycentrics=[[1, 0, 0]]), talweg.BadCurve,
                 "faces that the mesh"),
                (talweg.Curve(positions=np.full((2, 3), np.nan)), talweg.BadCurve, "not finite"),
                (talweg.Curve(), talweg.BadCurve, "no points"),
                ("abc", talweg.BadCurve, "A curve must be")):
            with self.subTest(why), self.assertRaisesRegex(error, why):
                talweg.show(mesh, given, file=self.folder / "a.png")
        for given, why in (((self.vertices, [[0, 1, n]]), f"vertex {n}, and the mesh has {n}"),
                           ((self.vertices, np.zeros((0, 3), int)), "no faces"),
                           ((np.full((3, 3), np.nan), [[0, 1, 2]]), "finite"),
                           (3, "not as int")):
            with self.subTest(why), self.assertRaisesRegex(talweg.BadMesh, why):
                talweg.show(given, file=self.folder / "a.png")
        self.assertFalse((self.folder / "a.png").exists())

    def test_a_script_without_a_window_is_told_what_to_do(self):
        with mock.patch.dict(os.environ, MPLBACKEND="agg"):
            os.environ.pop("DISPLAY", None)
            with self.assertRaisesRegex(talweg.Unsupported, 'file="picture.png"'):
                self.result.show()

    def test_window_of_matplotlib(self):
        from matplotlib import pyplot  # pylint: disable=import-outside-toplevel
        self.addCleanup(pyplot.close, "all")
        with mock.patch.object(pyplot, "get_backend", return_value="TkAgg"), \
                mock.patch.object(pyplot, "show") as opened:
            self.assertIsNone(self.result.show(engine="matplotlib", size=(400, 300)))
        opened.assert_called_once_with()
        self.assertEqual(tuple(pyplot.gcf().get_size_inches() * pyplot.gcf().dpi), (400, 300))

    def test_a_million_faces(self):
        """Takes 1.3 s of processor time where docs/python.md was measured."""
        mesh = talweg.Mesh(*support.read_ply(support.real_mesh("mouse_skull_984k.ply")))
        drawn = np.loadtxt(support.CURVES / "mouse_skull_984k.txt").astype(int)
        begin = time.process_time()
        talweg.show(mesh, drawn, file=self.folder / "a.png")
        self.assertLess(time.process_time() - begin, 10)

    def test_show_in_a_notebook(self):
        shown = []
        display = types.SimpleNamespace(Image=lambda data, format: data, display=shown.append)
        shell = types.SimpleNamespace(get_ipython=lambda: types.SimpleNamespace(kernel=1),
                                      display=display)
        with mock.patch.dict(sys.modules, {"IPython": shell, "IPython.display": display}):
            self.assertIsNone(self.result.show())
        self.assertEqual(shown, [self.result._repr_png_()])  # pylint: disable=protected-access


class Without(unittest.TestCase):
    def test_nothing_to_draw_with(self):
        result = talweg.smooth(support.hills(), support.staircase())
        with mock.patch.object(_windows, "there", lambda package: False):
            self.assertIsNone(result._repr_png_())  # pylint: disable=protected-access
            with self.assertRaisesRegex(talweg.Unsupported, "no matplotlib.*PyVista or vedo"):
                result.show(file="a.png")
            with self.assertRaisesRegex(talweg.Unsupported, "no vedo"):
                result.show(engine="vedo")
            with self.assertRaisesRegex(talweg.Unsupported, "no matplotlib"):
                talweg.plot_curvature(result)

    def test_results_without_a_mesh(self):
        result = talweg.Result([], [], talweg.Report())
        self.assertIsNone(result._repr_png_())  # pylint: disable=protected-access
        with self.assertRaisesRegex(talweg.BadUsage, "does not know its mesh"):
            result.show()

    def test_importing_talweg_loads_no_drawing(self):
        code = ("import sys, talweg; print([name for name in ('matplotlib', 'vtkmodules', 'vedo', "
                "'pyvista') if name in sys.modules])")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), "[]")


WINDOW = """
import sys, numpy as np
sys.path.insert(0, sys.argv[2])
import support, talweg
vertices, faces = support.hills()
result = talweg.smooth((vertices, faces), support.staircase())
result.show(engine=sys.argv[1], file="a.png", size=(320, 240))
talweg.show((vertices, faces), talweg.draw((vertices, faces), [305, 1820, 3055]), engine=sys.argv[1],
            file="b.png", colors=vertices[:, 2], size=(320, 240))
"""


class Windows(unittest.TestCase):
    """PyVista and vedo, with a display, or with Xvfb."""

    def run_with_display(self, engine, folder, **environment):
        display = [] if os.environ.get("DISPLAY") else ["xvfb-run", "-a"]
        if display and not shutil.which("xvfb-run"):
            self.skipTest("no display (Debian: xvfb xauth)")
        return subprocess.run(
            [*display, sys.executable, "-c", WINDOW, engine, Path(__file__).parent], cwd=folder,
            env={**os.environ, **environment}, text=True, check=False, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT)

    def check(self, engine, how):
        if not _windows.there(engine):
            self.skipTest(f"no {engine} ({how})")
        matplotlib_or_skip(self)
        from matplotlib import image  # pylint: disable=import-outside-toplevel
        with tempfile.TemporaryDirectory() as folder:
            done = self.run_with_display(engine, folder)
            self.assertEqual(done.returncode, 0, done.stdout)
            pixels = np.rint(255 * image.imread(Path(folder) / "a.png")[:, :, :3]).astype(int)
            other = image.imread(Path(folder) / "b.png")
        self.assertEqual(pixels.shape, (240, 320, 3))
        self.assertGreater(((pixels[:, :, 2] > pixels[:, :, 0] + 80)).sum(), 100)  # blue
        self.assertGreater(((pixels[:, :, 0] > pixels[:, :, 2] + 80)).sum(), 20)  # red
        self.assertGreater(len(np.unique(other.reshape(-1, other.shape[2]), axis=0)), 200)

    def test_vedo(self):
        self.check("vedo", "Debian: python3-vedo")

    def test_pyvista(self):
        self.check("pyvista", "pip install pyvista")

    def test_without_a_display(self):
        """Without a display VTK would end the program."""
        engine = next((name for name in ("vedo", "pyvista") if _windows.there(name)), None)
        if engine is None:
            self.skipTest("no vedo (Debian: python3-vedo)")
        with mock.patch.dict(os.environ):
            os.environ.pop("DISPLAY", None)
            if _windows.can_render():
                self.skipTest("this VTK draws without a display")
            with self.assertRaisesRegex(talweg.Unsupported, "needs a display"):
                talweg.show(support.hills(), engine=engine, file="a.png")


if __name__ == "__main__":
    unittest.main()
