"""What the documentation shows runs as written, and the menus it names exist."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import click
import pytest

from procc_annotator.cli.main import COMMANDS
from procc_annotator.gui.actions import ACTIONS

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
BLOCK = re.compile(r"(?:```(sh|python)|<!-- (prints))\n(.*?)(?:```|-->)", re.DOTALL)
PAGES = {
    path.relative_to(ROOT).as_posix(): path
    for path in (ROOT / "README.md", *sorted(DOCS.rglob("*.md")))
}
RECIPES = [
    name
    for name, path in PAGES.items()
    # Plug-ins need their packages; the sport's tutorial has tests of its own.
    if re.search("```(sh|python)\n", path.read_text())
    and "examples" not in path.parts
    and path.name != "a-sport-of-your-own.md"
]
MENU_PATH = re.compile(r"\*([A-Z]\w+(?: > [^*`]+)+)\*(?: \(((?:`[^`]+`(?: or )?)+)\))?")


def test_thirty_recipes_run():
    assert sum(name.startswith("docs/how-to/") for name in RECIPES) >= 30


@pytest.mark.parametrize("name", RECIPES)
def test_recipe_runs_and_prints_what_it_shows(name, tmp_path):
    """Blocks run one after the other, in a folder with a copy of the sample; a comment "prints"
    after one has lines of its output."""
    shutil.copytree(ROOT / "sample_data", tmp_path / "sample_data")
    printed = ""
    for kind, prints, block in BLOCK.findall(PAGES[name].read_text()):
        if prints:
            assert all(line in printed for line in map(squeezed, block.splitlines())), printed
        else:
            program = ["bash", "-ec"] if kind == "sh" else [sys.executable, "-c"]
            printed = squeezed(run([*program, block], tmp_path))


def run(command: Sequence[str], folder: Path, columns: int = 100) -> str:
    """What a command prints, with this checkout's program on the path and a home of its own."""
    environment = {
        **os.environ,
        "PATH": os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"])),
        "PYTHONPATH": str(ROOT),
        "HOME": str(folder),
        "COLUMNS": str(columns),
    }
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, timeout=300,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, (command, done.stdout, done.stderr)
    return done.stdout + done.stderr


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
            action = squeezed(action).rstrip("…")
            assert action in actions, (name, action)
            named = set(re.findall("`([^`]+)`", keys))
            assert named <= {key.replace("Return", "Enter") for key in actions[action]}
            found += 1
    assert found > 20


def commands() -> Iterator[tuple[str, Any]]:
    for lazy in COMMANDS:
        command = lazy.load()
        children = getattr(command, "commands", {})
        for name, child in children.items() or ((None, command),):
            yield f"{lazy.name} {name}" if name else str(lazy.name), child


@pytest.mark.parametrize(
    ("name", "command"), [pytest.param(*pair, id=pair[0].replace(" ", "-")) for pair in commands()]
)
def test_examples_of_help_run(name, command, tmp_path):
    examples = example_lines(command.epilog)
    assert len(examples) >= 2, name
    if name == "open":  # the window stays open; --selftest has its own test
        return
    shutil.copytree(ROOT / "sample_data", tmp_path / "sample_data")
    for example in examples:
        run(["bash", "-ec", example], tmp_path)


def example_lines(epilog: str) -> list[str]:
    """The commands of a help text, each as one line."""
    joined = re.sub(r"\\\n\s*", "", epilog)
    return [line.strip() for line in joined.splitlines() if line.startswith("  procc-annotator")]


def test_the_list_of_commands_is_whole():
    done = run([sys.executable, "-m", "procc_annotator", "--help"], ROOT, columns=80)
    assert "..." not in done.split("Commands:")[1].split("Examples:")[0]
    for name, command in commands():
        if name != "open":
            text = command.get_help(click.Context(command, info_name=name))
            assert "range>" not in text.lower()
