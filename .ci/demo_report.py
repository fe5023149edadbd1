"""A short report beside a grown terrain: python .ci/demo_report.py FOLDER NAME

Writes FOLDER/report.md from report.json and the fields: time by stage, and measures of relief with
the range that real, mainly non-glacial mountains have (at cells of about 100 m).
"""

import json
import sys
from pathlib import Path

import numpy as np

LOWLAND = 100.0  # m: where there is no map of land, what lies higher is measured
REAL = {"hypsometric integral": (0.19, 0.52), "mean slope": (9.0, 31.0)}


def slope_deg(elevation, cell_size):
    north, east = np.gradient(elevation, cell_size)
    return np.degrees(np.arctan(np.hypot(north, east)))


def pits(elevation, land):
    """Land cells, away from the rim, that no neighbour lies below."""
    inner = elevation[1:-1, 1:-1]
    ny, nx = elevation.shape
    lowest = np.full_like(inner, np.inf)
    for row in range(3):
        for column in range(3):
            if (row, column) != (1, 1):
                shifted = elevation[row : ny - 2 + row, column : nx - 2 + column]
                lowest = np.minimum(lowest, shifted)
    return int(((inner < lowest) & land[1:-1, 1:-1]).sum())


def measures(fields):
    elevation, cell = fields["elevation"].astype(float), float(fields["cell_size"])
    land = fields["land"] > 0 if "land" in fields else elevation > LOWLAND
    heights = elevation[land]
    yield "land", f"{land.sum() * cell * cell / 1e6:.0f} km²"
    yield "cell size", f"{cell:.1f} m"
    yield "highest point", f"{heights.max():.0f} m"
    yield "mean height", f"{heights.mean():.0f} m"
    integral = heights.mean() / heights.max()
    yield "hypsometric integral", f"{integral:.2f}"
    slope = slope_deg(elevation, cell)[land].mean()
    yield "mean slope", f"{slope:.1f}°"
    yield "pits", f"{100 * pits(elevation, land) / land.sum():.2f}% of cells"


def write_report(folder, name):
    report = json.loads((folder / "report.json").read_text())
    with np.load(folder / f"{name}.npz") as archive:
        wanted = {"elevation", "land", "cell_size"} & set(archive.files)
        fields = {key: archive[key] for key in wanted}
    lines = [f"# {name}", "", f"Orogen {report['version']}, seed {report['seed']}, "]
    lines[-1] += f"{report['grid']['nx']} x {report['grid']['ny']} cells."
    lines += ["", "| stage | seconds |", "|---|---|"]
    lines += [f"| {stage} | {seconds:.2f} |" for stage, seconds in report["seconds"].items()]
    lines += [f"| all | {sum(report['seconds'].values()):.2f} |"]
    lines += ["", "| measure | here | real mountains |", "|---|---|---|"]
    for measure, text in measures(fields):
        low, high = REAL.get(measure, (None, None))
        lines.append(f"| {measure} | {text} | {f'{low:g} to {high:g}' if low else ''} |")
    lines += ["", *(f"- {warning}" for warning in report["warnings"])]
    (folder / "report.md").write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    write_report(Path(sys.argv[1]), sys.argv[2])
