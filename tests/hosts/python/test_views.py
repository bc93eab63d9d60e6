"""Parts of pictures: the nearest face of every pixel, hidden points, and the direction of the view."""

import unittest
from unittest import mock

import numpy as np

import support
import talweg
from talweg import _camera, _raster, _scene, _shading


def sphere(n=60, radius=1.0):
    """Vertices and faces, counterclockwise from outside."""
    i, k = np.meshgrid(np.arange(1, n), np.arange(2 * n), indexing="ij")
    u, v = np.pi * i / n, np.pi * k / n
    points = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], -1).reshape(-1, 3)
    a = ((i - 1) * 2 * n + k)[:-1].ravel()
    b = ((i - 1) * 2 * n + (k + 1) % (2 * n))[:-1].ravel()
    ring = np.arange(2 * n)
    north, south = len(points), len(points) + 1
    last = (n - 2) * 2 * n
    faces = np.concatenate([
        np.stack([a, a + 2 * n, b + 2 * n], -1), np.stack([a, b + 2 * n, b], -1),
        np.stack([np.full(2 * n, north), ring, (ring + 1) % (2 * n)], -1),
        np.stack([np.full(2 * n, south), last + (ring + 1) % (2 * n), last + ring], -1)])
    return radius * np.vstack([points, [[0, 0, 1], [0, 0, -1]]]), faces


def frontal(vertices, size=200):
    """A camera on the z axis."""
    return _camera.framed(np.eye(3), vertices.min(axis=0), vertices.max(axis=0), size, size)


class Raster(unittest.TestCase):
    def test_the_nearest_triangle_of_every_pixel(self):
        random = np.random.RandomState(3)
        points = random.uniform(-10, 60, (300, 3))
        faces = random.randint(0, 300, (200, 3))
        faces = faces[[len(set(face)) == 3 for face in faces.tolist()]]
        buffer = _raster.Buffer(50, 40)
        buffer.draw(points, faces)
        expected = np.full((40, 50), -np.inf)
        y, x = np.mgrid[:40, :50]
        for a, b, c in points[faces]:
            m = np.linalg.inv(np.stack([np.append(p[:2], 1) for p in (a, b, c)], 1))
            weights = np.einsum("ij,jyx->iyx", m, np.stack([x, y, np.ones_like(x)]))
            z = np.einsum("i,iyx->yx", [a[2], b[2], c[2]], weights)
            expected = np.where((weights >= 0).all(axis=0), np.maximum(expected, z), expected)
        np.testing.assert_allclose(buffer.depths.reshape(40, 50), expected, rtol=1e-9)
        np.testing.assert_array_equal(buffer.faces.reshape(40, 50) == _raster.NOTHING,
                                      np.isneginf(expected))

    def test_nothing_is_open_between_neighbours(self):
        """There is no gap even if edges pass through centres of pixels."""
        for angle in (0, np.pi / 4, 0.3):
            vertices, faces = support.hills(30)
            turned = vertices[:, :2] @ [[np.cos(angle), np.sin(angle)],
                                        [-np.sin(angle), np.cos(angle)]]
            buffer = _raster.Buffer(40, 40)
            buffer.draw(np.column_stack([turned * 6 - 40, vertices[:, 2]]), faces)
            y, x = np.mgrid[:40, :40]
            given = (np.stack([x, y], -1) + 40) / 6 @ [[np.cos(angle), -np.sin(angle)],
                                                       [np.sin(angle), np.cos(angle)]]
            inside = ((given > 1e-9) & (given < 29 - 1e-9)).all(axis=-1)
            self.assertGreater(inside.sum(), 100)
            self.assertTrue((buffer.faces.reshape(40, 40)[inside] != _raster.NOTHING).all())

    def test_chunks(self):
        """The result does not depend on the size of chunks."""
        vertices, faces = sphere()
        points = frontal(vertices).project(vertices)
        whole = _raster.Buffer(200, 200)
        whole.draw(points, faces)
        with mock.patch.object(_raster, "_ROWS", 100), mock.patch.object(_raster, "_SAMPLES", 50):
            parts = _raster.Buffer(200, 200)
            parts.draw(points, faces)
        np.testing.assert_array_equal(parts.depths, whole.depths)

    def test_triangles_that_are_not_finite_are_left_out(self):
        points = np.array([[0, 0, 0], [9, 0, 0], [0, 9, 0], [np.nan, 3, 9], [np.inf, 3, 9]])
        buffer = _raster.Buffer(10, 10)
        buffer.draw(points, np.array([[0, 1, 2], [0, 1, 3], [1, 4, 2]]))
        self.assertEqual(set(buffer.faces.tolist()), {0, _raster.NOTHING})


class Hidden(unittest.TestCase):
    def test_sphere(self):
        vertices, faces = sphere()
        for scale in (1.0, 2.0**-60, 2.0**60):
            camera = frontal(scale * vertices)
            surface = _shading.Surface(scale * vertices, faces, camera)
            hidden = surface.hides(camera.project(scale * vertices))
            clear = np.abs(vertices[:, 2]) > 0.2  # away from the outline
            np.testing.assert_array_equal(hidden[clear], vertices[clear, 2] < 0)

    def test_pictures_do_not_depend_on_the_unit(self):
        vertices, faces = support.hills(30)
        one = _scene.scene((vertices, faces), [0, 31, 62], None, None, 1, None, (80, 60))
        other = _scene.scene((2.0**40 * vertices, faces), [0, 31, 62], None, None, 1, None, (80, 60))
        images = [_shading.Surface(s.vertices, s.faces, s.camera).image() for s in (one, other)]
        np.testing.assert_array_equal(*images)
        self.assertGreater(np.ptp(images[0].astype(int)), 50)


class Views(unittest.TestCase):
    def direction(self, vertices, faces, curve):
        seen = _scene.scene((vertices, faces), curve, None, None, 1, None, (80, 60))
        return seen.camera.axes[2]

    def test_from_the_side_of_the_curve(self):
        vertices, faces = sphere()
        for side in np.vstack([np.eye(3), -np.eye(3), [[1, 1, 1], [-1, 2, -1]]]):
            side = side / np.linalg.norm(side)
            patch = np.flatnonzero(vertices @ side > 0.9)
            direction = self.direction(vertices, faces, talweg.Curve(positions=vertices[patch]))
            self.assertGreater(direction @ side, 0.6)
            again = self.direction(vertices, faces, talweg.Curve(positions=vertices[patch[::-1]]))
            np.testing.assert_array_equal(direction, again)

    def test_the_view_avoids_faces_in_front_of_the_curve(self):
        """A curve on the inside of a bowl is seen through the opening."""
        vertices, faces = sphere()
        bowl = faces[(vertices[faces, 0] < 0.2).all(axis=1)][:, ::-1]  # faces inwards, open towards x
        line = np.flatnonzero((vertices[:, 0] < -0.6) & (np.abs(vertices[:, 2]) < 0.01))
        direction = self.direction(vertices, bowl, talweg.Curve(positions=vertices[line]))
        self.assertGreater(direction[0], 0.5)

    def test_terrain_is_upright(self):
        vertices, faces = support.hills()
        seen = _scene.scene((vertices, faces), None, None, None, 1, None, (80, 60))
        self.assertGreater(seen.camera.axes[1] @ [0, 0, 1], 0.1)
        self.assertGreater(seen.camera.axes[2] @ [0, 0, 1], 0.1)

    def test_frames(self):
        vertices, faces = sphere()
        patch = np.flatnonzero(vertices @ [0, 0, 1] > 0.97)
        curve = talweg.Curve(positions=vertices[patch])
        whole, near, nearer = (
            _scene.scene((vertices, faces), given, (0, 0, 1), (0, 1, 0), zoom, None, (80, 60)).camera
            for given, zoom in ((None, 1), (curve, 1), (curve, 2)))
        self.assertGreater(near.scale, 1.1 * whole.scale)
        self.assertAlmostEqual(nearer.scale, 2 * near.scale)
        np.testing.assert_allclose(near.project(vertices[[-2]])[0, :2], (39.5, 29.5), atol=2)
        np.testing.assert_allclose(near.axes, np.eye(3), atol=1e-15)


if __name__ == "__main__":
    unittest.main()
