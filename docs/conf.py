"""The documentation, built by `./dev docs`: MyST Markdown; reference pages are generated."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "docs" / "_ext"))

project = "Orogen"
author = "The Orogen developers"
copyright = "The Orogen developers, GPL-3.0-or-later"  # noqa: A001
version = release = re.search(
    r"project\(Orogen VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()
).group(1)

extensions = ["myst_parser", "sphinx.ext.mathjax", "declarations"]
myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
exclude_patterns = ["_build"]
html_theme = "furo"
html_title = f"Orogen {release}"
