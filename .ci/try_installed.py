"""Try the program as somebody installs it: wheel from the sdist, empty environment, no checkout.

Builds the sdist, the wheel from that sdist alone, installs it with the locked versions of what it
needs into an environment of its own in a temporary folder, and runs it there on a copy of the
sample. Prints what was installed, how large it is and how long it took. Standard library only.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BIN = "Scripts" if os.name == "nt" else "bin"
MB = 1_000_000
# The environment of whoever runs this must not help: neither the checkout nor their settings.
HIDDEN = ("PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV", "QT_PLUGIN_PATH")


def call(*command: object, cwd: Path, **environment: str) -> str:
    """Run a command; its output, or the end of this program with what it said."""
    kept = {name: value for name, value in os.environ.items() if name not in HIDDEN}
    done = subprocess.run(
        [str(part) for part in command],
        cwd=cwd,
        env={**kept, **environment},
        capture_output=True,
        text=True,
        check=False,
        timeout=900,
    )
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}:\n{done.stderr}")
    return done.stdout


@contextmanager
def timed(what: str) -> Iterator[None]:
    """Print how long something took."""
    began = time.perf_counter()
    yield
    print(f"{what:<46} {time.perf_counter() - began:6.1f} s", flush=True)


def build(work: Path) -> Path:
    """The wheel, built from the sdist as it is unpacked far from the checkout."""
    call(sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-d", work, cwd=ROOT)
    (sdist,) = work.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        archive.extractall(work / "unpacked", filter="data")
    (source,) = (work / "unpacked").iterdir()
    call(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", work, cwd=source)
    (wheel,) = work.glob("*.whl")
    print(f"{sdist.name} {sdist.stat().st_size / MB:.1f} MB, {wheel.name}"
          f" {wheel.stat().st_size / MB:.1f} MB")  # fmt: skip
    return wheel


def install(wheel: Path, work: Path) -> Path:
    """An environment with the wheel and what it needs, nothing else; its folder."""
    environment = work / "environment"
    uv = Path(sys.executable).with_name("uv")
    call(uv, "venv", "--quiet", "--python", sys.executable, environment, cwd=work)
    locked = call(uv, "export", "--frozen", "--no-dev", "--no-emit-project", "--no-hashes",
                  "--directory", ROOT, cwd=work)  # fmt: skip
    (work / "locked.txt").write_text(locked)
    with timed("installed with the locked versions in"):
        call(uv, "pip", "install", "--quiet", "--python", environment, wheel,
             "--requirement", work / "locked.txt", cwd=work)  # fmt: skip
    return environment


def tell_size(environment: Path) -> None:
    """Print how large it is, and how much of that is Qt."""
    (site,) = [p for p in environment.rglob("site-packages") if p.is_dir()]
    qt = sum(size_of(site / name) for name in ("PySide6", "shiboken6"))
    print(f"size: {size_of(site) / MB:.0f} MB, of which Qt {qt / MB:.0f} MB")


def size_of(folder: Path) -> int:
    return sum(f.stat().st_size for f in folder.rglob("*") if f.is_file() and not f.is_symlink())


def try_it(environment: Path, work: Path) -> None:
    """Run the program as a user would, in another folder, with a home of its own."""
    program = environment / BIN / "procc-annotator"
    sample = work / "sample"
    shutil.copytree(ROOT / "sample_data", sample, ignore=shutil.ignore_patterns("*.py", ".procc"))
    home = {"HOME": str(work / "home"), "XDG_CONFIG_HOME": str(work / "home")}
    where = call(environment / BIN / "python", "-c",
                 "import procc_annotator; print(procc_annotator.__file__)", cwd=work)  # fmt: skip
    if not Path(where.strip()).is_relative_to(environment):
        sys.exit(f"not the installed package was tried, but {where.strip()}")
    with timed("--version"):
        print(call(program, "--version", cwd=work, **home).strip())
    with timed("evaluate"):
        told = call(program, "evaluate", sample, sample / "cameras" / "true", cwd=work, **home)
    if "100.00" not in told:
        sys.exit(f"evaluate does not find the true cameras right:\n{told}")
    for folder in (sample, None):
        arguments = [folder] if folder is not None else []
        with timed("open --selftest" + (" on the sample" if folder else "")):
            told = call(program, "open", *arguments, "--selftest", cwd=work, **home)
            print(told.strip())


def main() -> None:
    with tempfile.TemporaryDirectory(prefix="procc_installed_") as made:
        work = Path(made)
        (work / "home").mkdir()
        with timed("sdist, and the wheel from it, in"):
            wheel = build(work)
        environment = install(wheel, work)
        tell_size(environment)
        try_it(environment, work)
    print("the installed program works")


if __name__ == "__main__":
    main()
