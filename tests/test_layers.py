"""Everything but the window works where Qt cannot be imported (a cluster node, say)."""

from __future__ import annotations

import ast
import pkgutil
import subprocess
import sys
from pathlib import Path

import procc_annotator

PACKAGE = Path(procc_annotator.__file__).parent


def test_only_gui_needs_qt() -> None:
    names = [
        module.name
        for module in pkgutil.walk_packages([str(PACKAGE)], "procc_annotator.")
        if not module.name.startswith("procc_annotator.gui")
        and not module.name.endswith("__main__")
    ]
    assert len(names) > 30
    code = (
        "import sys, importlib\n"
        "for name in ('PySide6', 'pyqtgraph'): sys.modules[name] = None\n"
        f"for name in {names!r}: importlib.import_module(name)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_the_live_state_knows_no_widget() -> None:
    """Panels, pictures and tasks stand on the state; none of it may stand on one of them."""
    above = ("picture", "panels", "plots", "tasks")
    files = list((PACKAGE / "gui" / "state").glob("*.py"))
    assert len(files) > 10
    for file in files:
        for node in ast.walk(ast.parse(file.read_text())):
            names = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            names += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            wrong = [
                n for n in names if n.startswith(tuple(f"procc_annotator.gui.{a}" for a in above))
            ]
            assert not wrong, f"{file.name} imports {wrong}"


def test_help_does_not_load_arrays_or_pictures() -> None:
    code = (
        "import sys\n"
        "from procc_annotator.cli.main import run\n"
        "sys.argv = ['procc-annotator', '--version']\n"
        "try:\n    run()\nexcept SystemExit:\n    pass\n"
        "heavy = [m for m in ('numpy', 'cv2', 'PySide6') if m in sys.modules]\n"
        "print('heavy:', heavy)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "heavy: []" in done.stdout, done.stdout + done.stderr
