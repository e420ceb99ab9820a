"""What the documentation shows runs as written, and the menus it names exist."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from procc_annotator.gui.actions import ACTIONS

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
BLOCK = re.compile(r"```(sh|python|text)\n(.*?)```", re.DOTALL)
PAGES = {
    path.relative_to(ROOT).as_posix(): path
    for path in (ROOT / "README.md", *sorted(DOCS.rglob("*.md")))
}
RECIPES = [name for name, path in PAGES.items() if re.search("```(sh|python)\n", path.read_text())]
MENU_PATH = re.compile(r"\*([A-Z]\w+(?: > [^*`]+)+)\*(?: \(((?:`[^`]+`(?: or )?)+)\))?")


def test_thirty_recipes_run():
    assert sum(name.startswith("docs/how-to/") for name in RECIPES) >= 30


@pytest.mark.parametrize("name", RECIPES)
def test_recipe_runs_and_prints_what_it_shows(name, tmp_path):
    """Blocks run one after the other, in a folder with a copy of the sample; a text block after
    one shows lines of its output ("..." stands for what is left out)."""
    shutil.copytree(ROOT / "sample_data", tmp_path / "sample_data")
    path = os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"]))
    environment = {
        **os.environ,
        "PATH": path,
        "PYTHONPATH": str(ROOT),
        "COLUMNS": "100",
        "DOCS": str(DOCS),
    }
    printed = ""
    for kind, block in BLOCK.findall(PAGES[name].read_text()):
        if kind == "text":
            missing = [line for line in map(squeezed, block.splitlines()) if line not in printed]
            assert not [line for line in missing if line != "..."], printed
            continue
        program = ["bash", "-ec"] if kind == "sh" else [sys.executable, "-c"]
        done = subprocess.run(
            [*program, block], cwd=tmp_path, env=environment, capture_output=True, text=True,
            timeout=300, check=False,
        )  # fmt: skip
        assert done.returncode == 0, (block, done.stdout, done.stderr)
        printed = squeezed(done.stdout + done.stderr)


def squeezed(text: str) -> str:
    """Text without the frames of tables, and with single blanks."""
    return " ".join(re.sub("[\u2500-\u257f]", " ", text).split())


def test_menus_and_keys_that_pages_name_exist():
    actions: dict[str, tuple[str, ...]] = {a.menu.replace("/", " > "): () for a in ACTIONS}
    for a in ACTIONS:
        actions[f"{a.menu.replace('/', ' > ')} > {a.text.lstrip('-').rstrip('…')}"] = a.keys
    found = 0
    for name, path in PAGES.items():
        for action, keys in MENU_PATH.findall(path.read_text()):
            assert action.rstrip("…") in actions, (name, action)
            named = set(re.findall("`([^`]+)`", keys))
            assert named <= {key.replace("Return", "Enter") for key in actions[action.rstrip("…")]}
            found += 1
    assert found > 20
