"""How the worker is started: which Python, which command, which environment."""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

# Options of a process beside Blender: no console (Windows); Ctrl-C in its terminal is not for it.
if sys.platform == "win32":
    APART = {"creationflags": subprocess.CREATE_NO_WINDOW}
else:
    APART = {"start_new_session": True}


class NoCore(RuntimeError):
    """The package `orogen` (the wheel in this extension) is not there for this Python."""


def core_folder():
    """The folder that holds the package `orogen`, found without importing it."""
    spec = importlib.util.find_spec("orogen")
    if spec is None or not spec.origin:
        raise NoCore(
            f"The extension holds no core for Python {sys.version_info[0]}.{sys.version_info[1]} "
            "on this system: install the extension's zip that was built for it"
        )
    return Path(spec.origin).parent.parent


def python_executable():
    """Blender's own Python. In a Blender that names itself there, the one beside its library."""
    if not Path(sys.executable).stem.lower().startswith("blender"):
        return sys.executable
    folder = Path(sys.prefix, "" if os.name == "nt" else "bin")
    for name in (f"python{sys.version_info[0]}.{sys.version_info[1]}", "python3", "python"):
        for candidate in (folder / name, folder / f"{name}.exe"):
            if candidate.is_file():
                return str(candidate)
    raise NoCore(f"Blender's Python was not found in {folder}")


def command(exchange):
    """-P: the working folder stays out of the search path; -u: no line waits in a buffer."""
    return [python_executable(), "-P", "-u", "-m", "orogen.worker", "--exchange", str(exchange)]


def environment():
    """This process's environment, with the way to the core and without what misleads Python."""
    result = dict(os.environ)
    for name in ("PYTHONHOME", "PYTHONSTARTUP", "PYTHONINSPECT"):
        result.pop(name, None)
    result["PYTHONPATH"] = str(core_folder())
    result["PYTHONIOENCODING"] = "utf-8"
    result["PYTHONDONTWRITEBYTECODE"] = "1"
    return result
