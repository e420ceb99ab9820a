"""Make the standalone folder, which needs no Python, and try it: dist/procc-annotator.

It is made in an environment of its own from the lock (group `bundle`), by PyInstaller with the spec
beside this file, then tried where neither Python nor the checkout is in sight. Prints size and
times. Standard library only.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "build" / "bundle"
FOLDER = ROOT / "dist" / "procc-annotator"
WINDOWS = os.name == "nt"
MB = 1_000_000


def call(*command: object, **environment: str) -> str:
    """Run a command at the root; its output, or the end of this program with what it said."""
    done = subprocess.run(
        [str(part) for part in command], cwd=ROOT, env={**os.environ, **environment},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode != 0:
        said = f"{done.stdout[-2000:]}\n{done.stderr[-4000:]}"
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}:\n{said}")
    return done.stdout


def environment() -> Path:
    """Python in an environment with the program, what it needs, and PyInstaller."""
    uv = Path(sys.executable).with_name("uv.exe" if WINDOWS else "uv")
    place = WORK / "environment"
    call(
        uv, "sync", "--frozen", "--no-dev", "--group", "bundle", "--no-editable", "--quiet",
        "--reinstall-package", "procc-annotator", "--python", sys.executable,
        UV_PROJECT_ENVIRONMENT=str(place), VIRTUAL_ENV="",
    )  # fmt: skip
    return place / ("Scripts/python.exe" if WINDOWS else "bin/python")


def packages_inside() -> list[str]:
    """Names of the packages that the program needs, and PyInstaller, whose loader starts it."""
    uv = Path(sys.executable).with_name("uv.exe" if WINDOWS else "uv")
    locked = call(uv, "export", "--frozen", "--no-dev", "--no-emit-project", "--no-hashes")
    wanted = ["pyinstaller"]
    for line in locked.splitlines():
        name, _, marker = line.partition(";")
        found = re.match(r"[A-Za-z0-9][\w.-]*(?===)", name)
        if found and ("win32" not in marker or WINDOWS):
            wanted.append(found.group())
    return list(dict.fromkeys(wanted))


def build() -> None:
    """Make the folder, with the list of what is inside."""
    python = environment()
    call(
        python, "-m", "PyInstaller", "--noconfirm", "--clean", "--log-level", "ERROR",
        "--distpath", FOLDER.parent, "--workpath", WORK / "work",
        ROOT / "packaging" / "procc-annotator.spec",
    )  # fmt: skip
    collected = WORK / "work" / "procc-annotator" / "COLLECT-00.toc"
    names = ",".join(packages_inside())
    listed = call(python, ROOT / "packaging" / "licences.py", FOLDER, collected, names)
    print(f"licences of {listed.strip()}: {FOLDER / 'LICENCES.txt'}")


def try_it() -> None:
    """Run it as a user would who has no Python, far from here; print how long it takes."""
    program = FOLDER / ("procc-annotator.exe" if WINDOWS else "procc-annotator")
    with tempfile.TemporaryDirectory(prefix="procc_bundle_") as made:
        home = Path(made)
        kept = {name: os.environ[name] for name in ("SYSTEMROOT", "TEMP") if name in os.environ}
        own = {**kept, "HOME": made, "PATH": str(home / "nothing"), "LANG": "C.UTF-8"}
        sample = home / "sample"
        shutil.copytree(FOLDER / "_internal" / "sample_data", sample)
        for words in (
            ["--version"],
            ["evaluate", sample, sample / "cameras" / "true"],
            ["calibrate", sample, home / "fitted", "--workers", "2"],
            ["open", "--selftest"],
            ["open", sample / "basketball", "--selftest"],
        ):
            began = time.perf_counter()
            done = subprocess.run(
                [str(program), *map(str, words)], cwd=made, env=own,
                capture_output=True, text=True, check=False, timeout=300,
            )  # fmt: skip
            took = time.perf_counter() - began
            shown = " ".join(str(word).replace(made, "") for word in words)
            if done.returncode != 0:
                sys.exit(f"{shown} ended with {done.returncode}:\n{done.stdout}\n{done.stderr}")
            print(f"{shown:<58} {took:5.1f} s", flush=True)


def main() -> None:
    began = time.perf_counter()
    build()
    size = sum(f.stat().st_size for f in FOLDER.rglob("*") if f.is_file() and not f.is_symlink())
    print(f"{FOLDER}: {size / MB:.0f} MB, made in {time.perf_counter() - began:.0f} s")
    try_it()
    print("the standalone folder works")


if __name__ == "__main__":
    main()
