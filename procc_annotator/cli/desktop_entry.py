"""``procc-annotator desktop-entry``: the program in the menus of a Linux desktop."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli.echo import echo
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.atomic import remove as remove_file
from procc_annotator.messages import pluralize
from procc_annotator.resources import resources_dir

HELP = """\
--install adds the program to the menus of a Linux desktop, with its icon, for folders, pictures,
videos and field.toml; --remove removes it. Files are written to XDG_DATA_HOME (~/.local/share)
only, without special rights. With neither option they are listed.

Exit code: 0; 2 on other systems.
"""

EXAMPLE = """\
  procc-annotator desktop-entry --install
  procc-annotator desktop-entry --remove
"""

ID = "org.procc.Annotator"
_SPECIAL = '"`$\\'
_REFRESHERS = (
    ("update-mime-database", "mime"),
    ("update-desktop-database", "applications"),
    ("gtk-update-icon-cache", "icons/hicolor"),
)


def desktop_entry(
    install: Annotated[
        bool, typer.Option("--install", help="Put the program into the desktop's menus.")
    ] = False,
    remove: Annotated[bool, typer.Option("--remove", help="Take it out again.")] = False,
) -> None:
    if not sys.platform.startswith("linux"):
        raise UsageError("desktop entries are of Linux; make a shortcut to procc-annotator-window")
    if install and remove:
        raise UsageError("--install and --remove exclude each other")
    home = data_home()
    files = entry_files()
    if install:
        for name, data in files.items():
            make_folder((home / name).parent)
            write_atomic(home / name, data)
        echo(f"{pluralize(len(files), 'file')} written below {home}")
    elif remove:
        there = [home / name for name in files if (home / name).exists()]
        for path in there:
            remove_file(path)
        echo(f"{pluralize(len(there), 'file')} removed below {home}")
    else:
        for name in files:
            there_too = " (there)" if (home / name).exists() else ""
            echo(f"{home / name}{there_too}")
        return
    refresh(home)


def data_home() -> Path:
    """Return where the user's own data of programs lie; a relative path in the variable does not
    count."""
    given = Path(os.environ.get("XDG_DATA_HOME", ""))
    return given if given.is_absolute() else Path.home() / ".local" / "share"


def entry_files() -> dict[str, bytes]:
    """Return what is installed: its place below the data folder, and its content. InputError if the
    installation of the program is incomplete."""
    source = resources_dir() / "desktop"
    try:
        entry = (source / f"{ID}.desktop").read_text(encoding="utf-8")
        files = {
            f"applications/{ID}.desktop": _with_command(entry).encode(),
            f"mime/packages/{ID}.xml": (source / f"{ID}.xml").read_bytes(),
            f"metainfo/{ID}.metainfo.xml": (source / f"{ID}.metainfo.xml").read_bytes(),
            f"icons/hicolor/scalable/apps/{ID}.svg": (source / f"{ID}.svg").read_bytes(),
        }
        for icon in sorted((source / "icons").glob("*.png"), key=lambda path: int(path.stem)):
            place = f"icons/hicolor/{icon.stem}x{icon.stem}/apps/{ID}.png"
            files[place] = icon.read_bytes()
    except OSError as error:
        raise InputError(
            source, f"cannot be read: {error.strerror or error}", advice="reinstall the program"
        ) from error
    return files


def window_command() -> list[str]:
    """Return what starts the window of this very installation."""
    if getattr(sys, "frozen", False):  # the standalone folder
        return [sys.executable, "open"]
    script = Path(sys.executable).with_name("procc-annotator-window")
    if script.is_file():
        return [str(script)]
    return [sys.executable, "-m", "procc_annotator", "open"]


def _with_command(entry: str) -> str:
    command = " ".join(map(_quoted, window_command()))
    return entry.replace("Exec=procc-annotator-window", f"Exec={command}")


def _quoted(argument: str) -> str:
    """An argument of an Exec line, by the rules of desktop entries: a string's backslashes are
    doubled once more, and a percent sign is two."""
    escaped = "".join(f"\\{c}" if c in _SPECIAL else c for c in argument)
    return '"' + escaped.replace("\\", "\\\\").replace("%", "%%") + '"'


def refresh(home: Path) -> None:
    """Have the desktop look again, where its tools are there: without, it does so at next login."""
    for tool, folder in _REFRESHERS:
        program = shutil.which(tool)
        if program is None or not (home / folder).is_dir():
            continue
        options = ["--force", "--ignore-theme-index"] if tool.startswith("gtk") else []
        done = subprocess.run(
            [program, *options, str(home / folder)], capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            said = (done.stderr or done.stdout).strip().splitlines()
            echo(f"note: {tool}: {said[0] if said else done.returncode}", err=True)
