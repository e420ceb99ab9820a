"""List what a standalone folder holds, with its licences: LICENCES.txt, and the texts in licences/.

Runs in the environment that the folder was made from.
"""

from __future__ import annotations

import ast
import shutil
import subprocess
import sys
import sysconfig
from importlib import metadata
from pathlib import Path

TEXTS = ("LICEN", "COPYING", "NOTICE", "AUTHORS")
HEAD = """\
What this folder holds, besides ProCC Annotator itself (MIT), and under which licences. The texts,
as their makers ship them, are in licences/.

Qt and PySide6 are used under the LGPL 3: they are separate files in _internal/PySide6, which you
may replace by your own builds of the same version. Their source is at https://code.qt.io.
"""


def licence_of(package: metadata.PackageMetadata) -> str:
    """What a package says of its licence, in a line."""
    for key in ("License-Expression", "License"):
        said = str(package.get(key, "")).strip()
        if said and said != "UNKNOWN" and "\n" not in said:
            return said
    classifiers = package.get_all("Classifier") or []
    found = [c.rpartition(" :: ")[2] for c in classifiers if c.startswith("License ::")]
    return ", ".join(found) or "see its text"


def copy_texts(package: metadata.Distribution, folder: Path) -> int:
    """Copy the licence texts that a package ships; how many."""
    count = 0
    for file in package.files or ():
        source = Path(str(package.locate_file(file)))
        if source.name.upper().startswith(TEXTS) and source.is_file():
            target = folder / package.metadata["Name"] / file.name
            if target.exists():
                target = target.with_name(f"{file.parent.name}_{file.name}")
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
            count += 1
    return count


def system_files(collected: Path) -> dict[str, Path]:
    """Libraries of this system that were put into the folder: name -> file.

    Args:
        collected: PyInstaller's list of what it collected, a Python literal.
    """
    own = {Path(sys.prefix).resolve(), Path(sys.base_prefix).resolve()}
    found = {}
    for entry in ast.literal_eval(collected.read_text(encoding="utf-8"))[0]:
        name, source, kind = entry[:3]
        path = Path(source).resolve() if source else Path()
        if kind == "BINARY" and not any(path.is_relative_to(folder) for folder in own):
            found[name] = path
    return found


def debian_package(file: Path) -> str:
    """The package of Debian or Ubuntu that a file is of; empty where that is not known."""
    if shutil.which("dpkg") is None:
        return ""
    for place in (file, Path(str(file).removeprefix("/usr"))):
        done = subprocess.run(
            ["dpkg", "-S", str(place)], capture_output=True, text=True, check=False
        )
        if done.returncode == 0:
            return done.stdout.partition(":")[0]
    return ""


def write(folder: Path, collected: Path, names: list[str]) -> str:
    """Write the list and the texts into the folder; what was listed, in a line.

    Args:
        folder: the standalone one.
        collected: as of `system_files`.
        names: of the packages that are inside.
    """
    texts = folder / "licences"
    lines = [HEAD, "Python packages", ""]
    for name in sorted(names, key=str.lower):
        package = metadata.distribution(name)
        copied = copy_texts(package, texts)
        said = "" if copied else " (ships no text)"
        lines.append(f"  {name} {package.version}: {licence_of(package.metadata)}{said}")
    lines += ["", f"Python {sys.version.split()[0]}: PSF-2.0"]
    text = Path(sysconfig.get_paths()["stdlib"]) / "LICENSE.txt"
    if text.is_file():
        (texts / "Python").mkdir(parents=True, exist_ok=True)
        shutil.copyfile(text, texts / "Python" / "LICENSE.txt")
    libraries = system_files(collected)
    packages: dict[str, list[str]] = {}
    for name, file in libraries.items():
        packages.setdefault(debian_package(file) or "of unknown origin", []).append(name)
    if packages:
        lines += ["", "Libraries of the system it was built on, by its packages", ""]
    for package_name in sorted(packages):
        lines.append(f"  {package_name}: {', '.join(sorted(packages[package_name]))}")
        copyright_file = Path("/usr/share/doc") / package_name / "copyright"
        if copyright_file.is_file():
            (texts / "system").mkdir(parents=True, exist_ok=True)
            shutil.copyfile(copyright_file, texts / "system" / f"{package_name}.txt")
    (folder / "LICENCES.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return (
        f"{len(names)} packages and {len(libraries)} libraries of {len(packages)} system packages"
    )


if __name__ == "__main__":
    print(write(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3].split(",")))
