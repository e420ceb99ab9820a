"""The field of a dataset: commands take the dataset's own, and say when another one fits."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import store_field
from procc_annotator.dataset.layout import FIELD_FILE
from procc_annotator.field.load import builtin_field_file, load_field
from tests.cli.conftest import Dataset


def keep_length(folder: Path, length: float) -> None:
    database = WorkspaceDatabase.open(folder, "tester")
    store_field(database, folder, load_field("soccer", length=length))
    assert database.close()


def scored(cli, dataset: Dataset, out: Path, *more: str) -> str:
    """The field that an evaluation names in its file."""
    done = cli("evaluate", *dataset.set_arguments, "--output", out, *more)
    assert done.exit_code == 0, done.stderr
    return str(json.loads(out.read_text())["field"])


def test_commands_take_the_datasets_own_field(cli, dataset, tmp_path) -> None:
    keep_length(dataset.root, 101.3)
    out = tmp_path / "scores.json"
    assert scored(cli, dataset, out) == "soccer 101.3 x 68 m"
    assert scored(cli, dataset, out, "--field", "soccer") == "soccer"  # what is said wins ...
    assert scored(cli, dataset, out) == "soccer 101.3 x 68 m"  # ... this once
    text = builtin_field_file("soccer").read_text(encoding="utf-8")
    (dataset.root / FIELD_FILE).write_text(text.replace('name = "soccer"', 'name = "ours"', 1))
    assert scored(cli, dataset, out) == "ours"


def test_every_set_has_a_field_of_its_own(cli, dataset, tmp_path) -> None:
    keep_length(dataset.root, 101.3)
    plain = tmp_path / "plain"
    plain.mkdir()
    for file in dataset.annotations.iterdir():
        (plain / file.name).write_bytes(file.read_bytes())
    arguments = ["evaluate", "--set", f"own={dataset.annotations}", "--set", f"plain={plain}",
                 "--cameras", f"true={dataset.cameras}"]  # fmt: skip
    done = cli(*arguments)
    assert done.exit_code == 0, done.stderr
    assert done.stdout.count("soccer 101.3 x 68 m") == 1
    done = cli("agree", dataset.annotations, plain)
    assert "soccer 101.3 x 68 m" in done.stdout  # the other one says nothing


def test_a_field_that_cannot_be_used_is_no_other_one(cli, dataset) -> None:
    (dataset.root / FIELD_FILE).write_text('name = "ours"')
    done = cli("evaluate", *dataset.set_arguments)
    assert done.exit_code == 2
    assert FIELD_FILE in done.stderr


@pytest.mark.parametrize("command", ["evaluate", "check", "calibrate", "agree"])
def test_classes_of_another_field_are_told(cli, dataset, tmp_path, command) -> None:
    own = tmp_path / "yard.toml"
    own.write_text(
        'name = "yard"\ntitle = "Yard"\n[[elements]]\nname = "fence"\ntitle = "Fence"\n'
        'group = "Lines"\ncolour = "#ff0000"\nshortcut = ""\nkind = "line"\n'
        "start = [-9, 0, 0]\nend = [9, 0, 0]\n"
    )
    places = {
        "evaluate": dataset.set_arguments,
        "check": [dataset.annotations],
        "calibrate": [dataset.annotations, tmp_path / "out"],
        "agree": [dataset.annotations, dataset.annotations],
    }[command]
    done = cli(command, *places, "--field", own)
    assert "the field Yard of yard.toml does not know" in done.stderr
    assert "Soccer knows all: --field soccer" in done.stderr
    assert "does not know" not in cli(command, *places).stderr


def test_a_field_file_that_cannot_be_used_is_told(cli, dataset, tmp_path) -> None:
    packed = tmp_path / "match.zip"
    with zipfile.ZipFile(packed, "w") as archive:
        for file in dataset.annotations.glob("*.json"):
            archive.write(file, file.name)
        archive.writestr("field.toml", "name = 'padel'")
    note = f"note: {packed} holds a field.toml, which is not used"
    assert note in cli("evaluate", packed, dataset.cameras).stderr
    assert note not in cli("evaluate", packed, dataset.cameras, "--field", "soccer").stderr
    (dataset.root / "field.toml").mkdir()
    done = cli("evaluate", *dataset.set_arguments)
    assert done.exit_code == 2
    assert "is a folder, expected a file" in done.stderr
