"""Labels in title case, as Blender's own are."""

SMALL = "a an and as at but by for from in into nor of on or over per the to up via with".split()


def title(name):
    """An identifier as a label: `cells_along_the_side` gives Cells Along the Side."""
    words = name.replace("_", " ").split()
    return " ".join(
        word if i and word in SMALL else word[:1].upper() + word[1:] for i, word in enumerate(words)
    )
