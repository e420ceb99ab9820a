"""Where system libraries of Qt are missing, the first line says which packages to install."""

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from procc_annotator.cli import open
from procc_annotator.cli.open import qt_missing_words, require_qt_libraries
from procc_annotator.errors import UsageError

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="of Linux")
QT = Path(find_spec("PySide6").origin).parent / "Qt"
# Names of one length: the files are changed in place, and the loader then looks for the second.
HIDDEN = {
    b"libxcb-cursor.so.0": b"libxcb-cursor.so.9",
    b"libxcb-keysyms.so.1": b"libxcb-keysyms.so.9",
}


@pytest.fixture
def lacking(tmp_path) -> Path:
    """Qt as it is on a system without two libraries of X11."""
    platforms = tmp_path / "PySide6" / "Qt" / "plugins" / "platforms"
    platforms.mkdir(parents=True)
    (tmp_path / "PySide6" / "Qt" / "lib").symlink_to(QT / "lib")
    (tmp_path / "PySide6" / "__init__.py").touch()
    for plugin in (QT / "plugins" / "platforms").glob("libq*.so"):
        data = plugin.read_bytes()
        for own, other in HIDDEN.items():
            data = data.replace(own + b"\0", other + b"\0")
        (platforms / plugin.name).write_bytes(data)
    return tmp_path


def tools(monkeypatch: pytest.MonkeyPatch, *there: str) -> None:
    monkeypatch.setattr(
        open.shutil, "which", lambda name: f"/bin/{name}" if name in there else None
    )


@pytest.mark.parametrize(
    ("tool", "said"),
    [
        ("apt-get", "sudo apt-get install libgl1 "),
        ("dnf", "sudo dnf install libglvnd-glx "),
        ("pacman", "sudo pacman -S libglvnd "),
        ("", "your package manager"),
    ],
)
def test_missing_libraries_are_named_with_the_command(lacking, monkeypatch, tool, said):
    tools(monkeypatch, tool)
    monkeypatch.setenv("QT_QPA_PLATFORM", "xcb")
    with pytest.raises(UsageError) as error:
        require_qt_libraries(lacking / "PySide6" / "Qt")
    assert str(error.value).startswith(
        "system libraries of the window are missing here: libxcb-cursor.so.9,"
        f" libxcb-keysyms.so.9; install with: {said}"
    )


def test_another_platform_that_loads_is_good_enough(lacking, monkeypatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "xcb;offscreen")
    require_qt_libraries(lacking / "PySide6" / "Qt")
    monkeypatch.setenv("QT_QPA_PLATFORM", "xcb")
    require_qt_libraries(QT)  # nothing is missing where these tests run


def test_an_import_that_fails_says_the_same(monkeypatch):
    tools(monkeypatch, "apt-get")
    error = ImportError("libEGL.so.1: cannot open shared object file: No such file or directory")
    assert qt_missing_words(error).startswith(
        "system libraries that Qt needs are missing here: libEGL.so.1; install with: sudo apt-get"
    )
    assert "cannot be loaded here: no such module" in qt_missing_words(
        ImportError("no such module")
    )


def test_the_command_says_it_in_its_first_line_instead_of_ending_abruptly(lacking, sample_data):
    code = f"""
import importlib.util, sys
from importlib.machinery import ModuleSpec
real = importlib.util.find_spec
def find(name, *more):
    return ModuleSpec(name, None, origin={str(lacking / "PySide6" / "__init__.py")!r}) \\
        if name == "PySide6" else real(name, *more)
importlib.util.find_spec = find
sys.argv = ["procc-annotator", "open", {str(sample_data)!r}]
from procc_annotator.cli.main import run
run()
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=60,
        env={**os.environ, "QT_QPA_PLATFORM": "xcb"},
    )  # fmt: skip
    assert done.returncode == 2
    first = done.stderr.splitlines()[0]
    assert first.startswith("procc-annotator: system libraries of the window are missing here:")
    assert "cursor" in first
