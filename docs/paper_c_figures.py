"""The figures of the validation page of paper C; part of paper_c.py, which see."""

from pathlib import Path

import matplotlib
import numpy as np
import orogen
from orogen.pictures import draw_strata, hillshade
from PIL import Image

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

IMAGES = Path(__file__).resolve().parent / "images"
ROCK, LINE, PALE = "#7a4a2b", "#28486e", "#d9cbb8"
SIDE = 640  # pixels of a map

pyplot.rcParams.update(
    {"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "orogen"}
)


def save(figure, name):
    figure.savefig(
        IMAGES / f"paper_c_{name}.png", dpi=110, bbox_inches="tight", metadata={"Software": None}
    )
    pyplot.close(figure)
    shrink(IMAGES / f"paper_c_{name}.png")


def shrink(file):
    Image.open(file).convert("RGB").quantize(128).save(file, optimize=True)


def photograph(file, name):
    picture = Image.open(file).convert("RGB")
    picture.save(IMAGES / f"paper_c_{name}.jpg", quality=86, optimize=True)


def profile(uplift, grown, middle):
    """Fig. 15: uplift across the range without folds, and the mountains that it makes."""
    figure, (above, below) = pyplot.subplots(2, 1, figsize=(7.2, 4.2), sharex=True)
    y = (np.arange(len(uplift)) + 0.5) * grown.grid.cell_size / 1000.0
    above.fill_between(y, 1000.0 * uplift, color=PALE)
    above.plot(y, 1000.0 * uplift, color=ROCK)
    above.axvspan(y[middle.start], y[middle.stop], color=LINE, alpha=0.12)
    above.set_ylabel("uplift rate (mm/yr)")
    heights = grown["elevation"]
    below.fill_between(y, heights.min(1), heights.max(1), color=PALE, label="lowest to highest")
    below.plot(y, heights.mean(1), color=ROCK, label="mean")
    below.set(ylabel="height (m)", xlabel="across the range (km)", ylim=(0.0, None))
    below.legend(frameon=False)
    save(figure, "profile")


def histograms(statistics):
    """Fig. 16, of the mean of all seeds."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7.2, 2.7))
    angle = np.mean([s.angle for s in statistics], 0)
    left.bar(2.5 + 5.0 * np.arange(len(angle)), 100.0 * angle, 4.6, color=ROCK)
    left.set(xlabel="fold normal against compression (°)", ylabel="% of crests", xlim=(0, 90))
    length = np.mean([s.wavelength for s in statistics], 0)
    right.bar(0.05 + 0.1 * np.arange(len(length)), 100.0 * length, 0.092, color=ROCK)
    right.set(xlabel="crest to crest, over the wavelength asked", ylabel="% of sections")
    right.set_xlim(0, 2.5)
    save(figure, "histograms")


def map_picture(terrain):
    """Shaded relief in the colours of the rock, north up."""
    shade = hillshade(terrain["elevation"], terrain.grid.cell_size)
    return Image.fromarray(draw_strata(terrain, shade)[::-1])


def side_by_side(name, images, titles, columns=2):
    rows = -(-len(images) // columns)
    shape = np.asarray(images[0]).shape
    size = (3.6 * columns, 3.6 * rows * shape[0] / shape[1] + 0.3 * rows)
    figure, axes = pyplot.subplots(rows, columns, figsize=size, squeeze=False)
    for axis in axes.flat:
        axis.axis("off")
    for axis, image, title in zip(axes.flat, images, titles, strict=False):
        axis.imshow(np.asarray(image), cmap="gray", interpolation="lanczos")
        axis.set_title(title, fontsize=9)
    figure.tight_layout()
    save(figure, name)


def fold_relief(layer, field):
    """Fig. 18: one folded layer from above, shaded."""
    height = layer.speed / layer.speed.max() * 900.0
    return np.clip(255.0 * hillshade(height.astype(np.float32), field.grid.cell_size), 0, 255)[::-1]


def sections(name, cuts):
    """Profiles one above the other: pairs of a section and a title."""
    figure, axes = pyplot.subplots(len(cuts), 1, figsize=(7.2, 2.1 * len(cuts)), squeeze=False)
    for axis, (cut, title) in zip(axes[:, 0], cuts, strict=True):
        top = float(cut.surface.max()) + 100.0
        rgba = cut.picture(1400, 420, top)
        extent = (0.0, cut.distance[-1] / 1000.0, cut.base, top)
        axis.imshow(rgba, extent=extent, aspect="auto")
        axis.plot(cut.distance / 1000.0, cut.surface, color="black", linewidth=0.7)
        axis.set_ylabel("m")
        axis.set_title(title, fontsize=9, loc="left")
    axes[-1, 0].set_xlabel("km")
    figure.tight_layout()
    save(figure, name)


def grow(recipe, resolution=SIDE):
    return orogen.generate(recipe, resolution=resolution)
