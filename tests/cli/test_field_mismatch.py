"""Annotations whose classes are not the field's: every command that reads them says so."""

import json

import pytest

pytestmark = pytest.mark.usefixtures("qapp")

NOTE = "note: the field Basketball (FIBA) does not know any of the "
FITS = "; Soccer knows all: --field soccer"


@pytest.mark.parametrize("command", ["compare", "convert", "render", "export"])
def test_the_field_that_fits_is_named(cli, dataset, tmp_path, command):
    given = {
        "compare": (f"a={dataset.cameras}", f"b={dataset.cameras}", dataset.root),
        "convert": (dataset.root, tmp_path / "out.zip", "--to", "cvat", "--overwrite"),
        "render": (dataset.root, tmp_path / "out", "--cameras", dataset.cameras, "--overwrite"),
        "export": (dataset.root, tmp_path / "out", "--overwrite"),
    }[command]
    done = cli(command, *given, "--field", "basketball_fiba")
    assert done.stderr.count(NOTE) == 1
    assert FITS in done.stderr
    assert "does not know" not in cli(command, *given, "--field", "soccer").stderr


def test_the_own_field_of_the_dataset_is_among_those_that_may_fit(cli, dataset):
    elements = "".join(
        f'[[elements]]\nname = "padel {n}"\ntitle = "Line {n}"\ngroup = "Lines"\nshortcut = ""\n'
        f'colour = "#ff{n:02d}00"\nkind = "line"\nstart = [0, {n}, 0]\nend = [1, {n}, 0]\n'
        for n in range(6)
    )
    (dataset.root / "field.toml").write_text(f'name = "padel"\ntitle = "Padel"\n{elements}')
    clicks = {f"padel {n}": [{"x": 0.1, "y": n / 10}, {"x": 0.9, "y": n / 10}] for n in range(6)}
    for file in dataset.annotations.glob("*.json"):
        file.write_text(json.dumps(clicks))
    done = cli("evaluate", *dataset.set_arguments, "--field", "soccer")
    assert "; Padel knows all, the dataset's own field: leave --field out" in done.stderr
    (dataset.root / "field.toml").unlink()
    done = cli("evaluate", *dataset.set_arguments)
    assert "does not know any of the 6 classes annotated here (padel 0," in done.stderr
    assert "; name the field they belong to: --field NAME or a .toml file" in done.stderr


def test_files_of_soccernet_are_not_written_for_classes_of_another_sport(cli, dataset, tmp_path):
    clicks = {f"3-points {n}": [{"x": 0.1, "y": 0.2}, {"x": 0.9, "y": 0.2}] for n in range(6)}
    for file in dataset.annotations.glob("*.json"):
        file.write_text(json.dumps(clicks))
    for to in ("soccernet-v3", "soccernet-gsr"):
        out = tmp_path / f"{to}.json"
        done = cli("convert", dataset.root, out, "--to", to, code=2)
        assert "is for the classes of SoccerNet" in done.stderr
        assert not out.exists()


def test_a_check_under_a_wrong_field_says_the_one_thing(cli, dataset, tmp_path):
    found = tmp_path / "found.json"
    given = ("check", dataset.root, "--field", "basketball_fiba")
    done = cli(*given, "-o", found, "--fail-on", "warning", code=1)
    assert done.stderr.count(NOTE) == 1
    assert FITS in done.stderr
    for word in ("no such class", "relabel", "did you mean"):
        assert word not in done.stdout
    findings = json.loads(found.read_text())["findings"]
    assert findings
    assert all(one["remedies"] == [] for one in findings if one["rule"] == "unknown class")
    assert "did you mean" not in found.read_text()


def test_a_slip_of_the_pen_keeps_its_remedy(cli, dataset):
    file = dataset.annotations / "1.json"
    file.write_text(file.read_text().replace("Side line left", "Side lines left"))
    done = cli("check", dataset.root)
    assert "relabel to" in done.stdout
    assert "does not know" not in done.stderr
