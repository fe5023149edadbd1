"""The gallery shows every recipe that ships."""

import re
from pathlib import Path

import orogen
import pytest

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE = (DOCS / "gallery.md").read_text()


def test_every_recipe_has_its_heading_and_no_other():
    assert sorted(re.findall(r"^### `(\w+)`$", PAGE, re.MULTILINE)) == orogen.shipped()


@pytest.mark.parametrize("name", orogen.shipped())
def test_it_has_one_picture_and_one_command(name):
    section = PAGE.split(f"### `{name}`")[1].split("\n#")[0]
    assert section.count("```{image}") == section.count("```sh") == 1
    assert f"images/gallery_{name}.jpg\n:alt: " in section
    assert f"./dev run python -m orogen generate {name} -o out/{name} --format tif\n" in section
    size = (DOCS / f"images/gallery_{name}.jpg").stat().st_size
    assert 5_000 < size <= 250_000
