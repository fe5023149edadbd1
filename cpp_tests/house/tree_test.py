"""The tree keeps its own rules: order of rooms, sizes of files, nothing of one machine in it."""

import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CORE = ROOT / "core"
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)

# Lines a file may have. STYLE: about 150 for a header, about 400 for a source; some slack on top.
LIMITS = {".h": 180, ".cpp": 440, ".py": 440, "_test.cpp": 640}
FOREIGN = re.compile(
    r"(?<![\w.])/(?:work|root|home/\w+)/"  # a path of somebody's machine
    r"|https?://[\w.-]*(?:mirror|artifact|nexus|proxy|snapshot)[\w.-]*"  # a package source
    r"|deb\.debian\.org|archive\.ubuntu\.com|files\.pythonhosted\.org"
)
TEXT = {".h", ".cpp", ".py", ".txt", ".cmake", ".in", ".toml", ".json", ".md", ".sh", ".map", ""}


def tracked_files():
    listing = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if listing.returncode:
        raise unittest.SkipTest("not a git checkout")
    return [ROOT / name for name in listing.stdout.split("\0") if name and (ROOT / name).exists()]


def rooms_above():
    """Each room with the rooms it may include, as core/CMakeLists.txt declares them."""
    text = (CORE / "CMakeLists.txt").read_text()
    above = {}
    for name, rest in re.findall(r"^orogen_room\((\w+)([^)]*)\)", text, re.MULTILINE):
        listed = re.search(r"\bROOMS((?: [a-z_]+)+)", rest)
        reach = {name}
        for room in listed.group(1).split() if listed else []:
            assert room in above, f"{name} names {room}, which does not stand above it"
            reach |= above[room]
        above[name] = reach
    above["python"] = set(above) | {"python"}
    return above


class Tree(unittest.TestCase):
    def test_a_room_includes_only_rooms_above_it(self):
        above = rooms_above()
        self.assertGreaterEqual(len(above), 9)
        checked = 0
        for file in sorted(CORE.rglob("*")):
            if file.suffix not in {".h", ".cpp"}:
                continue
            room = file.relative_to(CORE).parts[0]
            for include in INCLUDE.findall(file.read_text()):
                target = include.split("/")[0]
                if room == "python" and target not in above:
                    continue  # beside the bindings
                with self.subTest(file=str(file.relative_to(ROOT)), include=include):
                    self.assertIn(target, above[room])
                    self.assertTrue((CORE / include).exists())
                checked += 1
        self.assertGreater(checked, 20)

    def test_a_source_includes_its_own_header_first(self):
        for file in sorted(CORE.glob("[!p]*/*.cpp")) + sorted(CORE.glob("pipeline/*.cpp")):
            header = file.with_suffix(".h")
            if header.exists():
                with self.subTest(file=str(file.relative_to(ROOT))):
                    first = INCLUDE.findall(file.read_text())[0]
                    self.assertEqual(first, str(header.relative_to(CORE)))

    def test_headers_open_with_what_they_compute(self):
        for file in sorted(CORE.glob("*/*.h")):
            with self.subTest(file=str(file.relative_to(ROOT))):
                text = file.read_text()
                self.assertTrue(text.startswith("//"), "no opening comment")
                self.assertIn("#pragma once", text)

    def test_files_stay_short(self):
        for file in tracked_files():
            kind = "_test.cpp" if file.name.endswith("_test.cpp") else file.suffix
            limit = LIMITS.get(kind)
            if limit:
                with self.subTest(file=str(file.relative_to(ROOT))):
                    self.assertLessEqual(len(file.read_text().splitlines()), limit)

    def test_nothing_of_one_machine_is_in_the_tree(self):
        for file in tracked_files():
            if file.suffix not in TEXT or file == Path(__file__).resolve():
                continue
            with self.subTest(file=str(file.relative_to(ROOT))):
                self.assertIsNone(FOREIGN.search(file.read_text(errors="replace")))


if __name__ == "__main__":
    unittest.main()
