"""The validation page of paper C, with all its figures: ./dev validate

    python docs/paper_c.py BENCH [FOLD]

Measures the paper's tables and makes its figures anew, and writes docs/paper_c.md and the pictures
it shows. BENCH, the program of the benchmarks, gives Table 1 its times; FOLD is the picture that
paper_c_fold.py renders.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import orogen
import paper_c_figures as figures

HERE = Path(__file__).resolve().parent
SEEDS = range(20)
PRESETS = ("jura", "zagros", "alps", "andes", "digne", "schist")
LAYOUTS = {
    "viscous_only": "(1) compression alone",
    "one_fold_layer": "(2) λ = 7 km",
    "two_fold_layers_10_5": "(3) λ = 10 and 5 km",
    "two_fold_layers_15_3": "(4) λ = 15 and 3 km",
}
LANDFORMS = {"hard_cap": "(1) cliffs", "alternating_beds": "(2) summits", "cirque": "(3) cirque"}


def uniform_compression(size=100e3, cells=1024):
    grid = orogen.Grid(cells, cells, size / cells)
    strength = np.full(grid.shape, 0.3, np.float32)
    return orogen.tectonics.CompressionField.from_arrays(0 * strength, strength, grid)


def one_fold(field, wavelength, seed=0):
    layer = {"fold_wavelength": wavelength, "speed_share": 0.2}
    return orogen.folding.fold_layers(field, [layer], seed, uplift_rate=5e-4)[0]


def pieces(lines):
    return sum(len(line.points) - (not line.closed) for line in lines)


def table_1(bench, field):
    """Edges of the fold mesh, and times of skeleton and heights."""
    run = subprocess.run(
        [bench, "--benchmark_filter=^fold_(skeleton|heights)", "--benchmark_format=json"],
        capture_output=True,
        check=True,
    )
    times = {r["run_name"]: r["real_time"] for r in json.loads(run.stdout)["benchmarks"]}
    rows = []
    for wavelength, edges, skeleton, height in (
        (7000, 955, 0.9, 2.1),
        (3000, 4246, 3.7, 1.4),
        (1000, 36715, 53.0, 2.8),
    ):
        folded = one_fold(field, wavelength).skeleton
        a, b = folded.points[folded.edges[:, 0]], folded.points[folded.edges[:, 1]]
        inside = ((0 <= (a + b) / 2) & ((a + b) / 2 <= 100e3)).all(1)
        of_it = re.compile(rf"/{wavelength}\b")
        ours = [time for name, time in sorted(times.items()) if of_it.search(name)]
        rows.append(
            f"| {wavelength:,} | {edges:,} | {inside.sum():,} | {pieces(folded.top):,} | "
            f"{pieces(folded.bottom):,} | {skeleton} | {ours[1]:.1f} | {height} | {ours[0]:.1f} |"
        )
    return "\n".join(rows)


def span(values, scale=1.0):
    low, high = min(values) / scale, max(values) / scale
    return f"{low:.3g}" if low == high else f"{low:.3g} to {high:.3g}"


def declared(name):
    """Default of a parameter, wherever it is declared."""
    for stage in orogen.schema()["stages"]:
        for parameter in stage["parameters"]:
            if parameter["name"] == name:
                return parameter["default"]
    raise KeyError(name)


def table_2():
    columns = [orogen.strata.preset_column(name) for name in PRESETS]
    layers = [layer for column in columns for layer in column["layers"]]
    waves = [
        wave
        for column in columns
        for wave, layer in zip(
            orogen.strata.fold_wavelengths(column), column["layers"], strict=True
        )
        if layer["fold_share"] > 0
    ]
    shares = [layer["fold_share"] for layer in layers if layer["fold_share"] > 0]
    erodibility = [declared(f"{end}_erodibility") for end in ("hard", "soft")]
    talus = [declared(f"{end}_talus_deg") for end in ("soft", "hard")]
    rows = (
        ("layers", "2 to 10", span([len(c["layers"]) for c in columns])),
        ("thickness (km)", "0.1 to 5", span([x["thickness"] for x in layers], 1e3)),
        ("fold wavelength (km)", "0.5 to 20", span(waves, 1e3)),
        ("speed of folding over u", "0.01 to 0.5", span(shares)),
        ("mean uplift rate (m/yr)", "5e-4", f"{declared('target_uplift_rate'):g}"),
        ("erodibility k (1/yr)", "2.5e-7 to 8e-7", span(erodibility)),
        ("talus angle (°)", "30 to 50", span(talus)),
        ("landslide speed (m/yr)", "0.01", f"{declared('landslide_rate'):g}"),
    )
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def table_3(statistics):
    nodes = sum(s.nodes for s in statistics)
    ends = 100.0 * sum(s.ends for s in statistics) / nodes
    joints = 100.0 * sum(s.joints for s in statistics) / nodes
    length = np.mean([s.mean_length for s in statistics])
    wave = np.mean([s.mean_wavelength for s in statistics])
    return {
        "ends": f"{ends:.1f}%",
        "joints": f"{joints:.1f}%",
        "length": f"{length:.2f}",
        "wave": f"{wave:.3f}",
    }


def plates(size):
    """Two of them, with 40% of the map between."""
    low, high = -0.5 * size, 1.5 * size
    near, far = 0.08 * size, 0.92 * size
    return [
        {
            "name": "south",
            "points": [[low, low], [high, low], [high, near], [low, near]],
            "arrows": [[0, 0.1 * size]] * 4,
        },
        {
            "name": "north",
            "points": [[low, far], [high, far], [high, high], [low, high]],
            "arrows": [[0, 0]] * 4,
        },
    ]


def compression_alone():
    """Fig. 15: no folds, no fault, one rock."""
    return {
        "orogen": 1,
        "extent": {"origin": [0, 0], "size": [100e3, 100e3]},
        "resolution": 512,
        "phases": [{"years": 5e6, "plates": plates(100e3)}],
        "column": {"preset": "schist"},
        "stages": [
            {"stage": "collision", "parameters": {"fault": False}},
            {"stage": "fold_layers"},
            {"stage": "mountain_growth", "parameters": SIDES},
            {"stage": "outcrop"},
        ],
    }


SIDES = {"west_side": "closed", "east_side": "closed"}


def figure_15():
    recipe = compression_alone()
    for layer in (column := orogen.strata.preset_column("schist"))["layers"]:
        layer["fold_share"] = 0.0
    recipe["column"] = column
    grown = orogen.generate(recipe)
    uplift = grown["crust_uplift_rate"].mean(1)
    rising = np.flatnonzero(uplift > 0.01 * uplift.max())
    width = len(rising)
    middle = slice(rising[0] + int(0.35 * width), rising[0] + int(0.65 * width))
    figures.profile(uplift, grown, middle)
    inner = uplift[middle]
    return f"{100.0 * np.abs(inner / inner.mean() - 1.0).max():.1f}%"


def smoothed(heights, cells):
    """Means of blocks of cells."""
    rows, columns = (n // cells * cells for n in heights.shape)
    blocks = heights[:rows, :columns].reshape(rows // cells, cells, columns // cells, cells)
    return blocks.mean((1, 3))


def figure_17():
    grown = [figures.grow(name) for name in LAYOUTS]
    figures.side_by_side("layouts", [figures.map_picture(g) for g in grown], LAYOUTS.values())
    rows = []
    for title, terrain in zip(LAYOUTS.values(), grown, strict=True):
        crust = terrain["crust_uplift_rate"]
        middle = crust > 0.7 * crust.max()
        mean = 1000.0 * (crust + terrain["fold_uplift_rate"])[middle].mean()
        heights = terrain["elevation"]
        north, east = np.gradient(smoothed(heights, round(1000.0 / terrain.grid.cell_size)))
        ratio = (north**2).mean() / (east**2).mean()
        rows.append(f"| {title} | {mean:.2f} | {heights.max():.0f} | {ratio:.2f} |")
    return "\n".join(rows)


def figure_20():
    grown = [figures.grow(name) for name in LANDFORMS]
    pictures = [figures.map_picture(g) for g in grown]
    figures.side_by_side("landforms", pictures, LANDFORMS.values(), 3)
    cuts = []
    for title, terrain in zip(LANDFORMS.values(), grown, strict=True):
        low = np.array(terrain.grid.origin) + terrain.grid.cell_size
        size = terrain.grid.cell_size * np.array(terrain.grid.shape[::-1])
        middle = low[0] + size[0] / 2
        line = [(middle, low[1]), (middle, low[1] + size[1] - 2 * terrain.grid.cell_size)]
        base = float(terrain["elevation"].min()) - 600.0
        cuts.append((terrain.rocks.section(line, base=base), title))
    figures.sections("landform_sections", cuts)


def recipes(names):
    return ", ".join(f"`{name}`" for name in names)


def main(bench, fold=None):
    figures.IMAGES.mkdir(exist_ok=True)
    if fold:
        figures.photograph(fold, "fold")
    field = uniform_compression()
    folded = [one_fold(field, 3000.0, seed) for seed in SEEDS]
    statistics = [orogen.folding.fold_statistics(field, f.skeleton, 3000.0) for f in folded]
    figures.histograms(statistics)
    figures.side_by_side(
        "folds",
        [figures.fold_relief(f, field)[:512, :512] for f in folded[:2]],
        ["seed 0", "seed 1"],
    )
    values = {
        "version": orogen.__version__,
        "table_1": table_1(bench, field),
        "table_2": table_2(),
        "uniform": figure_15(),
        "table_17": figure_17(),
        "fold_recipes": recipes(LAYOUTS),
        "landform_recipes": recipes(LANDFORMS),
        **table_3(statistics),
    }
    figure_20()
    text = (HERE / "paper_c_page.txt").read_text(encoding="utf-8")
    for name, value in values.items():
        text = text.replace("{{" + name + "}}", value)
    (HERE / "paper_c.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
