"""Packages of Linux distributions that hold the system libraries Qt needs.

Standard library only: `.ci/setup_system.py` reads the table before anything is installed.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from typing import NamedTuple


class Packages(NamedTuple):
    """Who holds a library: on Debian and Ubuntu, on Fedora and its kin, on Arch."""

    apt: str
    dnf: str
    pacman: str


# By the library's name before ``.so``.
PACKAGES = {
    "libGL": Packages("libgl1", "libglvnd-glx", "libglvnd"),
    "libGLX": Packages("libglx0", "libglvnd-glx", "libglvnd"),
    "libGLdispatch": Packages("libglvnd0", "libglvnd", "libglvnd"),
    "libOpenGL": Packages("libopengl0", "libglvnd-opengl", "libglvnd"),
    "libEGL": Packages("libegl1", "libglvnd-egl", "libglvnd"),
    "libX11": Packages("libx11-6", "libX11", "libx11"),
    "libX11-xcb": Packages("libx11-xcb1", "libX11-xcb", "libx11"),
    "libICE": Packages("libice6", "libICE", "libice"),
    "libSM": Packages("libsm6", "libSM", "libsm"),
    "libdbus-1": Packages("libdbus-1-3", "dbus-libs", "dbus"),
    "libfontconfig": Packages("libfontconfig1", "fontconfig", "fontconfig"),
    "libfreetype": Packages("libfreetype6", "freetype", "freetype2"),
    "libglib-2.0": Packages("libglib2.0-0", "glib2", "glib2"),
    "libgthread-2.0": Packages("libglib2.0-0", "glib2", "glib2"),
    "libwayland-client": Packages("libwayland-client0", "libwayland-client", "wayland"),
    "libwayland-cursor": Packages("libwayland-cursor0", "libwayland-cursor", "wayland"),
    "libwayland-egl": Packages("libwayland-egl1", "libwayland-egl", "wayland"),
    "libxcb": Packages("libxcb1", "libxcb", "libxcb"),
    "libxcb-cursor": Packages("libxcb-cursor0", "xcb-util-cursor", "xcb-util-cursor"),
    "libxcb-icccm": Packages("libxcb-icccm4", "xcb-util-wm", "xcb-util-wm"),
    "libxcb-image": Packages("libxcb-image0", "xcb-util-image", "xcb-util-image"),
    "libxcb-keysyms": Packages("libxcb-keysyms1", "xcb-util-keysyms", "xcb-util-keysyms"),
    "libxcb-randr": Packages("libxcb-randr0", "libxcb", "libxcb"),
    "libxcb-render": Packages("libxcb-render0", "libxcb", "libxcb"),
    "libxcb-render-util": Packages(
        "libxcb-render-util0", "xcb-util-renderutil", "xcb-util-renderutil"
    ),
    "libxcb-shape": Packages("libxcb-shape0", "libxcb", "libxcb"),
    "libxcb-shm": Packages("libxcb-shm0", "libxcb", "libxcb"),
    "libxcb-sync": Packages("libxcb-sync1", "libxcb", "libxcb"),
    "libxcb-util": Packages("libxcb-util1", "xcb-util", "xcb-util"),
    "libxcb-xfixes": Packages("libxcb-xfixes0", "libxcb", "libxcb"),
    "libxcb-xkb": Packages("libxcb-xkb1", "libxcb", "libxcb"),
    "libxkbcommon": Packages("libxkbcommon0", "libxkbcommon", "libxkbcommon"),
    "libxkbcommon-x11": Packages("libxkbcommon-x11-0", "libxkbcommon-x11", "libxkbcommon-x11"),
    "libz": Packages("zlib1g", "zlib", "zlib"),
    "libzstd": Packages("libzstd1", "libzstd", "zstd"),
}
_COMMANDS = {
    "apt-get": ("apt", "sudo apt-get install"),
    "dnf": ("dnf", "sudo dnf install"),
    "pacman": ("pacman", "sudo pacman -S"),
}


def stem_of(library: str) -> str:
    """``libxcb-cursor`` of ``libxcb-cursor.so.0``."""
    return library.partition(".so")[0]


def how_to_install(libraries: Iterable[str]) -> str:
    """What is missing, as packages, and the command that installs them, in one line.

    Args:
        libraries: names of files that were not found, ``libxcb-cursor.so.0``.

    Returns:
        For the package manager that is here; where none is that is known, for every one of them.
    """
    wanted = sorted(set(libraries))
    known = [PACKAGES[stem_of(one)] for one in wanted if stem_of(one) in PACKAGES]
    others = [one for one in wanted if stem_of(one) not in PACKAGES]
    here = [tool for tool in _COMMANDS if shutil.which(tool)][:1] or list(_COMMANDS)
    named = _each_once(known, _COMMANDS[here[0]][0])
    missing = [*named, *others] if len(here) == 1 else wanted
    commands = [
        f"{command} {' '.join(_each_once(known, kind))}"
        for kind, command in (_COMMANDS[tool] for tool in here if known)
    ]
    if others:
        commands.append(f"your package manager what holds {', '.join(others)}")
    joined = (", and with " if others and len(commands) == 2 else ", or ").join(commands)
    return f"missing here: {', '.join(missing)}; install with: {joined}"


def _each_once(packages: Iterable[Packages], kind: str) -> list[str]:
    return list(dict.fromkeys(getattr(package, kind) for package in packages))
