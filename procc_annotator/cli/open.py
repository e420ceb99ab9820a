"""Command ``open``: open the window; check its system libraries."""

from __future__ import annotations

import ctypes
import gc
import importlib.util
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli.echo import echo
from procc_annotator.cli.method_arguments import parse_sources
from procc_annotator.cli.options import Lines, Sources, chosen_field
from procc_annotator.dataset.layout import FIELD_FILE, frames_folder
from procc_annotator.errors import UsageError, require_existing
from procc_annotator.image.headers import VIDEO_SUFFIXES

_NOT_FOUND = re.compile(r"^\s*(\S+) => not found", re.MULTILINE)
_NAMED = re.compile(r"(\S+\.so[.\d]*): cannot open shared object file")
_WIDGETS = "lib/libQt6Widgets.so.6"
# All that Qt's window needs: what is there already is passed over.
_INSTALL = {
    "apt-get": "sudo apt-get install libgl1 libegl1 libopengl0 libglib2.0-0 libdbus-1-3"
    " libfontconfig1 libfreetype6 libx11-xcb1 libsm6 libxkbcommon-x11-0 libxcb-cursor0"
    " libxcb-icccm4 libxcb-image0 libxcb-keysyms1 libxcb-randr0 libxcb-render-util0 libxcb-shape0"
    " libxcb-shm0 libxcb-sync1 libxcb-util1 libxcb-xfixes0 libxcb-xkb1 libwayland-cursor0"
    " libwayland-egl1",
    "dnf": "sudo dnf install libglvnd-glx libglvnd-egl libglvnd-opengl glib2 dbus-libs fontconfig"
    " freetype libX11-xcb libSM libxkbcommon-x11 libxcb xcb-util xcb-util-cursor xcb-util-wm"
    " xcb-util-image xcb-util-keysyms xcb-util-renderutil libwayland-cursor libwayland-egl",
    "pacman": "sudo pacman -S libglvnd glib2 dbus fontconfig freetype2 libx11 libsm"
    " libxkbcommon-x11 libxcb xcb-util xcb-util-cursor xcb-util-wm xcb-util-image"
    " xcb-util-keysyms xcb-util-renderutil wayland",
}


def require_qt_libraries(folder: Path | None = None) -> None:
    """Refuse to open the window (UsageError) where system libraries are missing, with the line that
    installs them: Qt would end the process with a list of its plugins.

    Nothing is done on other systems, nor if Qt's folder (with ``lib`` and ``plugins``) is not
    found. What is loaded here Qt would load a moment later."""
    qt = folder or _qt_folder()
    if qt is None or not sys.platform.startswith("linux"):
        return
    plugins = [qt / "plugins" / "platforms" / f"libq{name}.so" for name in _platforms()]
    plugins = [plugin for plugin in plugins if plugin.is_file()]
    if not plugins or any(map(_loads, plugins)):
        return
    if missing := missing_libraries(plugins[0]):
        raise UsageError(f"system libraries of the window are {_how_to_install(missing)}")


def qt_missing_words(error: ImportError) -> str:
    """Return the remark on Qt that could not be imported: which system libraries are missing, or
    the error itself."""
    folder = _qt_folder()
    found = set(_NAMED.findall(str(error)))
    if folder is not None and found and sys.platform.startswith("linux"):
        found |= set(missing_libraries(folder / _WIDGETS))
        for name in _platforms()[:1]:
            found |= set(missing_libraries(folder / "plugins" / "platforms" / f"libq{name}.so"))
    if found:
        return f"system libraries that Qt needs are {_how_to_install(found)}"
    return f"this needs Qt, which cannot be loaded here: {error}"


def _how_to_install(libraries: Iterable[str]) -> str:
    commands = [command for tool, command in _INSTALL.items() if shutil.which(tool)][:1]
    what = " or ".join(commands) or "your package manager"
    return f"missing here: {', '.join(sorted(libraries))}; install with: {what}"


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


HELP = """\
PATH is a folder of pictures (or its field.toml), a picture, a video, a season (a folder with
videos, a .csv that lists them, or the output of track), or nothing. The word "open" may be left
out.

--selftest tests the installation: the window opens (off screen, unless QT_QPA_PLATFORM is set), an
element is annotated in a copy of a picture, saved and read again. Exit code: 0 if all succeeded, 2
if not. No setting or file of yours is changed.
"""

EXAMPLE = """\
  procc-annotator open sample_data --cameras sample_data/cameras/bad
  procc-annotator open sample_data/volleyball --cameras late=sample_data/volleyball/cameras/late
"""


@dataclass(frozen=True)
class OpenOptions:
    """Options of `open`."""

    path: Annotated[
        Path | None, typer.Argument(help="Folder of pictures, one picture, a video or a season.")
    ] = None
    annotations: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="Folder of the annotation files, if not next to the pictures."
        ),
    ] = None
    cameras: Sources = None
    field: Annotated[
        str | None,
        typer.Option(
            "--field",
            metavar="NAME|FILE[:DIMENSIONS]",
            help="The field that PATH shows, which its dataset remembers.  [default: what it"
            " remembers, or what its classes suggest]",
        ),
    ] = None
    lines: Lines = None
    selftest: Annotated[
        bool, typer.Option("--selftest", help="Try the window on a copy of a picture, and end.")
    ] = False


def open_window(given: OpenOptions) -> None:
    path = given.path
    if path is not None and path.name == FIELD_FILE and path.is_file():
        path = path.parent  # a dataset's own, opened from a file manager
    if given.selftest:
        os.environ["QT_QPA_PLATFORM"] = os.environ.get("QT_QPA_PLATFORM") or "offscreen"
        raise typer.Exit(_selftest(path, given.field, given.lines))
    texts = given.cameras or []
    sources = parse_sources(texts)
    require_existing(path, given.annotations, *(source.path for source in sources))
    if path is not None and given.annotations is not None and path.suffix.lower() in VIDEO_SUFFIXES:
        raise UsageError(
            f"{path} is a video, whose annotations lie in {frames_folder(path)}: open it without"
            " --annotations, or move them there"
        )
    if not display_available():
        raise UsageError(
            "there is no display for the window; `evaluate`, `export` and `render` work without"
        )
    require_qt_libraries()
    gc.disable()  # what is imported stays; the window looks for garbage when it is there
    from procc_annotator.gui.app import CameraChoice, main

    shown = None
    if given.field is not None:
        shown = chosen_field(given.field, lines=given.lines)
    elif given.lines is not None:
        shown = chosen_field(None, path, lines=given.lines)
    choices = [
        # A path alone leaves the name open, so that one given in the window earlier comes back.
        CameraChoice(s.path, s.format, None if str(s.path) == str(Path(text)) else s.name)
        for s, text in zip(sources, texts, strict=True)
    ]
    raise typer.Exit(main(path, annotations=given.annotations, cameras=choices, field=shown))


def _selftest(path: Path | None, field: str | None, lines: str | None) -> int:
    require_existing(path)
    require_qt_libraries()
    from procc_annotator.gui.selftest import run_selftest

    shown = chosen_field(field, lines=lines) if field is not None else None
    echo(run_selftest(path, shown))
    return 0


def display_available() -> bool:
    """Return whether Qt can show a window here; asking Qt itself would end the process."""
    if not sys.platform.startswith("linux"):
        return True
    return any(os.environ.get(n) for n in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"))
