"""``field list``, ``check`` and ``show``."""

import json
import re
import zipfile
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import store_field
from procc_annotator.dataset.layout import FIELD_FILE
from procc_annotator.field.load import builtin_field_file, field_names, load_field
from procc_annotator.resources import resources_dir
from tests.cli.conftest import Dataset

SOCCER = (resources_dir() / "field" / "soccer.toml").read_text(encoding="utf-8")


@pytest.fixture
def mine(tmp_path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(SOCCER.replace('name = "soccer"', 'name = "mine"', 1), encoding="utf-8")
    return path


def test_list_names_every_field_with_its_size_and_rules(cli):
    done = cli("field", "list")
    for name in field_names():
        assert re.search(rf"\b{name} ", done.stdout), name
    assert "60 x 26-30 m" in done.stdout
    assert "IIHF" in done.stdout


def test_check_passes_what_comes_with_the_program(cli, mine):
    done = cli("field", "check", "ice_hockey_nhl")
    assert (done.exit_code, done.stderr) == (0, "")
    assert "Ice hockey (NHL): 49 elements, 19 dimensions: nothing to mend" in done.stdout
    cli("field", "check", str(mine))


def test_check_names_what_to_mend(cli, mine):
    text = mine.read_text(encoding="utf-8")
    mine.write_text(text.replace("-goal_height", "goal_height"), encoding="utf-8")
    done = cli("field", "check", str(mine), code=1)
    number = text[: text.index('name = "Goal left crossbar"')].count("\n")
    line = (
        f"warning: {mine}: line {number}: element 'Goal left crossbar': lies 2.44 m below the"
        " ground (z points down"
    )
    assert line in done.stdout
    assert "6 to look at" in done.stdout


def test_check_knows_the_keys_of_the_window(cli, mine):
    text = mine.read_text(encoding="utf-8")
    mine.write_text(text.replace('shortcut = "3"', 'shortcut = "x"', 1), encoding="utf-8")
    done = cli("field", "check", str(mine), code=1)
    assert "the key x is taken by the window: hide all overlays" in done.stdout


def test_check_says_where_a_field_cannot_be_read(cli, mine):
    text = mine.read_text(encoding="utf-8")
    mine.write_text(text.replace('"circle_radius"', '"circle_radios"', 1), encoding="utf-8")
    line = text[: text.index('"circle_radius"')].count("\n") + 1
    done = cli("field", "check", str(mine), code=2)
    assert f"{mine}: line {line}: element 'Circle central'.radius: bad formula" in done.stderr
    assert "did you mean 'circle_radius'?" in done.stderr


def test_show_tells_elements_dimensions_and_symmetries(cli, tmp_path, monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    done = cli("field", "show", "ice_hockey_iihf:width=26")
    rows = {r.split("│")[1].strip(): r for r in done.stdout.splitlines() if r.startswith("│")}
    assert "13.35" in rows["Far right corner"]
    assert "arc, optional" in rows["Far right corner"]
    assert "0.00 to 1.22" in rows["Left goal left post"]
    assert "26 (nominal 30)" in rows["Width"]
    assert "26 to 30" in rows["Width"]
    assert "fixed" in rows["Face-off circle radius"]
    assert "looks the same turned by 180 degrees" in done.stdout
    assert "rules: IIHF" in done.stdout


def test_show_draws_every_element_in_its_colour(cli, tmp_path):
    out = tmp_path / "map.png"
    done = cli("field", "show", "soccer", "--output", str(out))
    assert (done.exit_code, done.stderr) == (0, "")
    blue, green, red = cv2.imread(str(out)).astype(np.uint32).transpose(2, 0, 1)
    colours = set(np.unique(red << 16 | green << 8 | blue).tolist())
    for element in load_field("soccer").elements:
        assert int(element.colour[1:], 16) in colours, element.title


def test_show_writes_an_svg_that_can_be_searched_and_does_not_change(cli, tmp_path):
    outs = [tmp_path / "a.svg", tmp_path / "b.SVG"]
    for out in outs:
        cli("field", "show", "ice_hockey_iihf", "-o", str(out))
    text = outs[0].read_text(encoding="utf-8")
    assert text == outs[1].read_text(encoding="utf-8")
    for element in load_field("ice_hockey_iihf").elements:
        assert element.title in text


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("map.pdf", "expected a name that ends in .png or .svg"),
        ("map", "expected a name that ends in .png or .svg"),
        ("file/map.png", "is a file, expected a folder; choose another place"),
        ("file/below/map.png", "is a file, expected a folder; choose another place"),
    ],
)
def test_show_refuses_what_it_cannot_write(cli, tmp_path, name, told):
    (tmp_path / "file").write_text("", encoding="utf-8")
    done = cli("field", "show", "soccer", "--output", str(tmp_path / name), code=2)
    assert told in done.stderr


def test_show_never_writes_over_the_field(cli, mine):
    link = mine.with_suffix(".svg")
    link.symlink_to(mine)
    before = mine.read_bytes()
    cli("field", "show", str(mine), "-o", str(link), code=2)
    assert mine.read_bytes() == before


@pytest.mark.parametrize("command", ["list", "check", "show"])
def test_the_commands_have_help_with_an_example(cli, command):
    done = cli("field", command, "--help")
    assert f"procc-annotator field {command}" in done.stdout


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("basketball_fiba:length", "write e.g. basketball_fiba:length=28 (metres)"),
        ("basketball_fiba:", "write e.g. basketball_fiba:length=28 (metres)"),
        ("soccer:width=66,width=67", "width is given twice"),
        ("soccer:lenght=100", "soccer: no dimension 'lenght'; did you mean 'length'?"),
        ("tennis:wall=3", "(there are length, width, "),
        ("soccer:length=nan", "soccer: length: expected a finite number"),
        (
            "basketball_fiba:line_width=0.04",
            "basketball_fiba: line_width cannot be 0.04 m: the rules fix it at 0.05 m (a field file"
            " of your own may allow it)",
        ),
    ],
)
def test_dimensions_that_cannot_be_are_told_without_the_installed_file(cli, text, says):
    done = cli("field", "show", text, code=2)
    assert says in done.stderr
    assert ".toml" not in done.stderr


def test_show_tells_kinds_and_the_side_of_the_paint(cli):
    shown = cli("field", "show", "basketball_fiba").stdout
    sideline = next(line for line in shown.splitlines() if "Near sideline" in line)
    assert "0.05, outside" in sideline  # the court is measured to the inner edge
    circle = next(line for line in shown.splitlines() if "Centre circle" in line)
    assert "0.05, inside" in circle
    assert "polyline" in next(line for line in shown.splitlines() if "Left backboard " in line)
    shown = cli("field", "show", "handball").stdout
    goal_area = next(line for line in shown.splitlines() if "Left goal-area line" in line)
    assert "chain" in goal_area
    assert "0.05, inside" in goal_area


# The field of a dataset: commands take the dataset's own, and say when another one fits.


def keep_length(folder: Path, length: float) -> None:
    database = WorkspaceDatabase.open(folder, "tester")
    store_field(database, folder, load_field("soccer", length=length))
    assert database.close()


def scored(cli, dataset: Dataset, out: Path, *more: str) -> str:
    """The field that an evaluation names in its file."""
    cli("evaluate", *dataset.set_arguments, "--output", out, *more)
    return str(json.loads(out.read_text())["field"])


def test_commands_take_the_datasets_own_field(cli, dataset, tmp_path):
    keep_length(dataset.root, 101.3)
    out = tmp_path / "scores.json"
    assert scored(cli, dataset, out) == "soccer 101.3 x 68 m"
    assert scored(cli, dataset, out, "--field", "soccer") == "soccer"  # what is said wins ...
    assert scored(cli, dataset, out) == "soccer 101.3 x 68 m"  # ... this once
    text = builtin_field_file("soccer").read_text(encoding="utf-8")
    (dataset.root / FIELD_FILE).write_text(text.replace('name = "soccer"', 'name = "ours"', 1))
    assert scored(cli, dataset, out) == "ours"


def test_every_set_has_a_field_of_its_own(cli, dataset, tmp_path):
    keep_length(dataset.root, 101.3)
    plain = tmp_path / "plain"
    plain.mkdir()
    for file in dataset.annotations.iterdir():
        (plain / file.name).write_bytes(file.read_bytes())
    arguments = ["evaluate", "--set", f"own={dataset.annotations}", "--set", f"plain={plain}",
                 "--cameras", f"true={dataset.cameras}"]  # fmt: skip
    done = cli(*arguments)
    assert done.stdout.count("soccer 101.3 x 68 m") == 1
    done = cli("agree", dataset.annotations, plain)
    assert "soccer 101.3 x 68 m" in done.stdout  # the other one says nothing


def test_a_field_that_cannot_be_used_is_no_other_one(cli, dataset):
    (dataset.root / FIELD_FILE).write_text('name = "ours"')
    done = cli("evaluate", *dataset.set_arguments, code=2)
    assert FIELD_FILE in done.stderr


@pytest.mark.parametrize("command", ["evaluate", "check", "calibrate", "agree"])
def test_classes_of_another_field_are_told(cli, dataset, tmp_path, command):
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
    assert "does not know" not in cli(command, *places, code=None).stderr


def test_a_field_file_that_cannot_be_used_is_told(cli, dataset, tmp_path):
    packed = tmp_path / "match.zip"
    with zipfile.ZipFile(packed, "w") as archive:
        for file in dataset.annotations.glob("*.json"):
            archive.write(file, file.name)
        archive.writestr("field.toml", "name = 'padel'")
    note = f"note: {packed} holds a field.toml, which is not used"
    assert note in cli("evaluate", packed, dataset.cameras).stderr
    assert note not in cli("evaluate", packed, dataset.cameras, "--field", "soccer").stderr
    (dataset.root / "field.toml").mkdir()
    done = cli("evaluate", *dataset.set_arguments, code=2)
    assert "is a folder, expected a file" in done.stderr
