"""Whether the system has what Qt's window needs; said before Qt would end the process."""

from __future__ import annotations

import ctypes
import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

from procc_annotator.cli.system_packages import how_to_install
from procc_annotator.errors import UsageError

_NOT_FOUND = re.compile(r"^\s*(\S+) => not found", re.MULTILINE)
_NAMED = re.compile(r"(\S+\.so[.\d]*): cannot open shared object file")
_WIDGETS = "lib/libQt6Widgets.so.6"


def require_qt_libraries(folder: Path | None = None) -> None:
    """Refuse to open the window where system libraries are missing, with the line that installs
    them: Qt would end the process with a list of its plugins.

    Nothing is done on other systems, nor where it cannot be told. What is loaded here Qt would load
    a moment later.

    Args:
        folder: Qt's, with ``lib`` and ``plugins``; None finds it.

    Raises:
        UsageError: what is missing.
    """
    qt = folder or _qt_folder()
    if qt is None or not sys.platform.startswith("linux"):
        return
    plugins = [qt / "plugins" / "platforms" / f"libq{name}.so" for name in _platforms()]
    plugins = [plugin for plugin in plugins if plugin.is_file()]
    if not plugins or any(map(_loads, plugins)):
        return
    if missing := missing_libraries(plugins[0]):
        raise UsageError(f"system libraries of the window are {how_to_install(missing)}")


def qt_missing_words(error: ImportError) -> str:
    """What to say of Qt that could not be imported: which system libraries are missing, or the
    error itself."""
    folder = _qt_folder()
    found = set(_NAMED.findall(str(error)))
    if folder is not None and found and sys.platform.startswith("linux"):
        found |= set(missing_libraries(folder / _WIDGETS))
        for name in _platforms()[:1]:
            found |= set(missing_libraries(folder / "plugins" / "platforms" / f"libq{name}.so"))
    if found:
        return f"system libraries that Qt needs are {how_to_install(found)}"
    return f"this needs Qt, which cannot be loaded here: {error}"


def missing_libraries(file: Path) -> list[str]:
    """Names of the libraries that a library needs and the system's loader does not find."""
    try:
        listed = subprocess.run(
            ["ldd", str(file)], capture_output=True, text=True, check=False, timeout=30
        ).stdout
    except (OSError, subprocess.TimeoutExpired):  # no ldd: the loader names the first one
        listed = ""
    found = set(_NOT_FOUND.findall(listed))
    if not found:
        try:
            ctypes.CDLL(str(file))
        except OSError as error:
            found = set(_NAMED.findall(str(error)))
    return sorted(found)


def _loads(plugin: Path) -> bool:
    try:
        ctypes.CDLL(str(plugin))
    except OSError:
        return False
    return True


def _platforms() -> list[str]:
    """Names of the platform plugins that Qt would try here, in its order."""
    chosen = os.environ.get("QT_QPA_PLATFORM")
    if chosen:
        return [name.partition(":")[0] for name in chosen.split(";")]
    names = []
    if os.environ.get("WAYLAND_DISPLAY"):
        names.append("wayland")
    if os.environ.get("DISPLAY") or not names:
        names.append("xcb")
    return names


def _qt_folder() -> Path | None:
    """Qt's folder inside PySide6, found without loading it."""
    try:
        found = importlib.util.find_spec("PySide6")
    except (ImportError, ValueError):  # what cannot even be looked for says so when it is imported
        return None
    if found is None or found.origin is None:
        return None
    return Path(found.origin).parent / "Qt"
