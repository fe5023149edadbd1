"""Reference pages from the declarations in the core, so that they cannot drift from the program.

    ```{stages}
    ```
    ```{fields}
    ```

`orogen.schema()` is the only source.
"""

import orogen
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList


def _number(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


def _range(parameter):
    if parameter["choices"]:
        return ", ".join(f"`{name}`" for name in parameter["choices"])
    if parameter["type"] == "bool":
        return "yes, no"
    unit = parameter["unit"]
    ends = f"{_number(parameter['min'])} to {_number(parameter['max'])}"
    return f"{ends} {unit}" if unit not in ("", "1") else ends


def _default(parameter):
    value = parameter["default"]
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"`{value}`" if isinstance(value, str) else _number(value)


def _names(fields):
    return ", ".join(f"`{name}`" for name in fields) or "nothing"


def stage_lines(stage):
    lines = [f"## {stage['name']}", "", stage["text"], ""]
    needs = f" Needs of the recipe: {_names(stage['inputs'])}." if stage["inputs"] else ""
    takes = f"; takes {_names(stage['may_read'])} if it is there" if stage["may_read"] else ""
    writes = f"writes {_names(stage['writes'])}"
    lines += [f"Reads {_names(stage['reads'])}{takes}; {writes}.{needs}", ""]
    lines += [f"*{stage['citation']}*", ""]
    if stage["parameters"]:
        lines += ["| parameter | default | allowed | meaning |", "|---|---|---|---|"]
        lines += [
            f"| `{p['name']}` | {_default(p)} | {_range(p)} | {p['description']} |"
            for p in stage["parameters"]
        ]
    return [*lines, ""]


def field_lines(fields):
    lines = ["| field | type | unit | meaning |", "|---|---|---|---|"]
    for field in fields:
        unit = field["unit"] or "1"
        lines.append(f"| `{field['name']}` | {field['type']} | {unit} | {field['description']} |")
    return lines


class _Generated(Directive):
    def lines(self):
        raise NotImplementedError

    def run(self):
        node = nodes.section()
        node.document = self.state.document
        self.state.nested_parse(
            StringList(self.lines(), source="orogen.schema()"), 0, node, match_titles=1
        )
        return node.children


class Stages(_Generated):
    def lines(self):
        return [line for stage in orogen.schema()["stages"] for line in stage_lines(stage)]


class Fields(_Generated):
    def lines(self):
        return field_lines(orogen.schema()["fields"])


def setup(app):
    app.add_directive("stages", Stages)
    app.add_directive("fields", Fields)
    return {"parallel_read_safe": True}
