# A route over hills, drawn in a hurry, smoothed: a notebook in cells (# %%), or a program that writes
# its pictures into the folder that it is given (default: the current one). Needs numpy and talweg,
# for the pictures matplotlib (Debian: python3-numpy python3-matplotlib).

# %% A mesh: a height field of 200 x 200 vertices, 10 m apart
import sys
from pathlib import Path

import numpy as np

import talweg

n, spacing = 200, 10.0
x, y = np.meshgrid(np.arange(n) * spacing, np.arange(n) * spacing, indexing="ij")
height = np.zeros_like(x)
random = np.random.RandomState(7)
for size in (600, 300, 150, 75):  # metres; smaller hills are lower and more
    for _ in range(int(12 * (600 / size) ** 1.5)):
        cx, cy = random.uniform(0, n * spacing, 2)
        bump = np.exp(-((x - cx) ** 2 + (y - cy) ** 2) / (size / 2) ** 2)
        height += random.choice([-1, 1]) * size / 8 * bump
vertices = np.stack([x, y, height], axis=-1).reshape(-1, 3)
a = np.arange(n * n).reshape(n, n)[:-1, :-1].ravel()
faces = np.concatenate([np.stack([a, a + n, a + n + 1], -1), np.stack([a, a + n + 1, a + 1], -1)])

# %% A drawing: a winding route by a trembling hand, as positions; Talweg puts them on the surface
t = np.linspace(0, 1, 120)
route = np.stack([200 + 1550 * t, 950 + 550 * np.sin(7 * t) * (1 - 0.3 * t)], axis=-1)
route += 8 * random.standard_normal(route.shape)
column = np.round(route / spacing).astype(int)
drawn = np.column_stack([route, height[column[:, 0], column[:, 1]]])

# %% Smoothed: the mesh is opened once, the curve set once; each tau costs only what tau touches
mesh = talweg.Mesh(vertices, faces)
work = mesh.workspace(drawn)
smoothed = {}
for tau in (0, 0.05, 1):
    smoothed[tau] = work.smooth(tau, point_fields=True)  # fields: deviation and curvature
    r = smoothed[tau].report
    print(f"tau = {tau}: {r.length_after:.0f} m, curvature {r.curvature_before:.1f} -> "
          f"{r.curvature_after:.1f} rad, {r.farthest:.0f} m from the drawing where farthest")

# %% As smooth as it gets within 30 m of the drawing
within = work.smooth(max_deviation=30)
print(f"within 30 m: tau = {within.report.tau:.3g}, curvature "
      f"{within.report.curvature_after:.1f} rad, {within.report.farthest:.1f} m")

# %% The distance to the drawing at every vertex
field = mesh.distance(drawn)
print(f"farthest from the drawing: {field.distance_max:.0f} m along the surface")

# %% Pictures
folder = Path(sys.argv[1] if len(sys.argv) > 1 and Path(sys.argv[1]).is_dir() else ".")
try:
    import matplotlib
except ImportError:
    sys.exit("No pictures: there is no matplotlib.")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

slope_x, slope_y = np.gradient(height, spacing)
light = (1 + 0.8 * slope_x - 0.8 * slope_y) / np.sqrt(1 + slope_x**2 + slope_y**2)
colours = {0: "#1b7837", 1: "#1450c0", 0.05: "#e08214"}


def show(axes, title):
    axes.imshow(light.T, origin="lower", cmap="gray", vmin=0.2, vmax=1.6,
                extent=(0, (n - 1) * spacing, 0, (n - 1) * spacing))
    axes.set_title(title)
    axes.set_xlabel("m")


def line(axes, positions, colour, label, width=1.6):
    axes.plot(*positions[:, :2].T, color=colour, linewidth=width, label=label)


figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 5.4), layout="constrained")
for axes, title in ((left, "Drawn, and smoothed"), (right, "A detail")):
    show(axes, title)
    line(axes, drawn, "#c8281e", "drawn", 1.2)
    for tau, result in smoothed.items():
        line(axes, result.curve.positions, colours[tau], f"tau = {tau}")
right.set(xlim=(250, 800), ylim=(1100, 1600))
left.legend(loc="upper right")
figure.savefig(folder / "python_terrain.png", dpi=72)

figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 5.4), layout="constrained")
show(left, "Distance to the drawing, lines every 100 m")
left.contour(x, y, field.distance.reshape(n, n), levels=np.arange(100, 2000, 100), linewidths=0.7,
             cmap="viridis")
line(left, drawn, "#c8281e", "drawn")
for tau, result in smoothed.items():
    curve = result.curve
    along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(curve.positions, axis=0), axis=1))]
    right.plot(along, curve.fields["deviation"], color=colours[tau], label=f"tau = {tau}")
right.set(title="How far each point moved", xlabel="m along the curve", ylabel="m")
right.legend()
figure.savefig(folder / "python_fields.png", dpi=72)
print(f"{folder / 'python_terrain.png'}, {folder / 'python_fields.png'}")
