"""Which field a dataset shows: its own file, what it keeps, the default; across several sets."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.batch.joint_calibration import estimate_dimensions
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import (
    DIMENSIONS_SETTING,
    FIELD_SETTING,
    field_of_dataset,
    field_of_datasets,
    field_settings,
    store_dimensions,
    store_field,
)
from procc_annotator.dataset.diagnostics import classes_in, mismatch_of, rank_fields
from procc_annotator.dataset.layout import FIELD_FILE, copy_sample, folder_of_dataset
from procc_annotator.errors import FieldError, InputError, SaveError, UsageError
from procc_annotator.field.load import builtin_field_file, load_field, with_dimensions, with_lines

OTHER = """
name = "yard"
title = "Yard"
[dimensions]
length = { title = "Length", nominal = 20, minimum = 18, maximum = 22 }
width = { title = "Width", nominal = 10, minimum = 10, maximum = 10 }
[[elements]]
name = "fence"
title = "Fence"
group = "Lines"
colour = "#ff0000"
shortcut = "1"
kind = "line"
start = ["-length / 2", "0", "0"]
end = ["length / 2", "0", "0"]
"""


def keep(folder: Path, *, field: str | Path = "soccer", **dimensions: float) -> None:
    database = WorkspaceDatabase.open(folder, "one")
    store_field(database, folder, load_field(field, **dimensions))
    assert database.close()


def test_a_dataset_that_says_nothing_shows_the_default_field(tmp_path):
    found = field_of_dataset(tmp_path)
    assert (found.field, found.chosen, found.notices) == (load_field(None), False, ())
    assert not list(tmp_path.iterdir())  # asking leaves nothing behind
    assert not field_of_dataset(tmp_path / "nowhere.zip").chosen


def test_a_dataset_remembers_its_field_with_the_dimensions(tmp_path):
    keep(tmp_path, length=101.3)
    folder = tmp_path / "annotations"
    folder.mkdir()
    (folder / "1.json").write_text("{}")
    for place in (tmp_path, folder, folder / "1.json"):
        found = field_of_dataset(place)
        assert found.chosen
        assert found.field.described == "soccer 101.3 x 68 m"


def test_frames_of_a_video_are_a_dataset_of_their_own(tmp_path):
    video, frames = tmp_path / "match.mp4", tmp_path / "match_frames"
    frames.mkdir()
    video.write_bytes(b"")
    (frames / "match_000001.json").write_text("{}")
    keep(frames, length=101.3)
    (tmp_path / FIELD_FILE).write_text(OTHER)  # of nothing: no picture or annotation lies here
    for place in (video, tmp_path, frames, frames / "match_000001.json"):
        assert field_of_dataset(place).field.described == "soccer 101.3 x 68 m"
    (tmp_path / "1.json").write_text("{}")
    assert field_of_dataset(tmp_path).field.name == "yard"
    assert field_of_dataset(video).field.name == "soccer"


def test_a_file_inside_the_dataset_moves_with_it(tmp_path):
    before = tmp_path / "before"
    (before / "fields").mkdir(parents=True)
    (before / "fields" / "yard.toml").write_text(OTHER)
    keep(before, field=before / "fields" / "yard.toml", length=21)
    moved = before.rename(tmp_path / "after")
    found = field_of_dataset(moved).field
    assert found.described == "yard 21 x 10 m"
    assert found.source == moved / "fields" / "yard.toml"


def test_the_file_in_the_dataset_decides(tmp_path):
    keep(tmp_path)
    (tmp_path / FIELD_FILE).write_text(OTHER)
    assert field_of_dataset(tmp_path).field.name == "yard"
    (tmp_path / FIELD_FILE).write_text("name = 3")
    with pytest.raises(FieldError, match=FIELD_FILE):  # never another field in its place
        field_of_dataset(tmp_path)


def test_a_field_that_is_gone_is_told(tmp_path):
    own = tmp_path / "yard.toml"
    own.write_text(OTHER)
    keep(tmp_path, field=own)
    own.unlink()
    with pytest.raises(FieldError, match=r"yard\.toml: no such file"):
        field_of_dataset(tmp_path)
    database = WorkspaceDatabase.open(tmp_path, "one")
    database.set_setting(FIELD_SETTING, json.dumps(["soccer"]))
    assert database.close()
    with pytest.raises(FieldError, match="cannot be read"):
        field_of_dataset(tmp_path)


def test_dimensions_of_another_field_are_left(tmp_path):
    keep(tmp_path, length=101.3)
    (tmp_path / FIELD_FILE).write_text(OTHER)
    assert field_of_dataset(tmp_path).field.is_nominal


def test_a_dataset_remembers_where_its_lines_are(tmp_path):
    database = WorkspaceDatabase.open(tmp_path, "one")
    store_field(database, tmp_path, with_lines(load_field("soccer", length=101.3), "middle"))
    assert database.close()
    found = field_of_dataset(tmp_path)
    assert found.chosen
    assert found.field.described == "soccer 101.3 x 68 m, lines at their middle"
    keep(tmp_path)
    assert field_of_dataset(tmp_path).field == load_field("soccer")
    own = tmp_path / FIELD_FILE
    own.write_text('lines = "middle"' + OTHER)  # the file may say so, and be overruled
    assert field_of_dataset(tmp_path).field.lines == "middle"
    database = WorkspaceDatabase.open(tmp_path, "one")
    store_field(database, tmp_path, with_lines(load_field(own), "measured"))
    assert database.close()
    assert field_of_dataset(tmp_path).field.lines == "measured"
    database = WorkspaceDatabase.open(tmp_path, "one")
    database.set_setting("field_lines", '{"field": "yard", "lines": "edge"}')
    assert database.close()
    found = field_of_dataset(tmp_path)
    assert found.field.lines == "middle"
    assert "cannot be read" in found.notices[0]


def test_a_workspace_that_cannot_be_read_is_told(tmp_path):
    keep(tmp_path)
    kept = field_of_dataset(tmp_path)
    (tmp_path / ".procc" / "workspace.db").write_bytes(b"no database at all" * 100)
    found = field_of_dataset(tmp_path)
    assert (found.field, found.chosen) == (kept.field, True)
    assert "its backup of 20" in found.notices[0]
    (tmp_path / ".procc" / "workspace.db.backup").unlink()
    found = field_of_dataset(tmp_path)
    assert not found.chosen
    assert "workspace cannot be read" in found.notices[0]


def test_several_datasets_show_one_field(tmp_path):
    one, two, three = (tmp_path / name for name in "abc")
    for folder in (one, two, three):
        folder.mkdir()
    keep(one, length=101.3)
    assert field_of_datasets([one, two]).field.described == "soccer 101.3 x 68 m"
    (three / FIELD_FILE).write_text(OTHER)
    with pytest.raises(UsageError, match="different fields"):
        field_of_datasets([one, three])


def test_a_copy_of_a_shipped_description_is_a_file_of_its_own(tmp_path):
    copy = tmp_path / "soccer.toml"
    copy.write_text(builtin_field_file("soccer").read_text(encoding="utf-8"), encoding="utf-8")
    keep(tmp_path, field=copy)
    found = field_of_dataset(tmp_path).field
    assert found.source == copy
    assert with_dimensions(found, {"length": 100}).source == copy


# What a workspace keeps of its field: read again, forgiven when damaged, left when of another.


def test_dimensions_are_there_when_the_dataset_is_opened_again(tmp_path):
    field = load_field("soccer")
    first = WorkspaceDatabase.open(tmp_path, "one")
    store_dimensions(first, with_dimensions(field, {"length": 101.3}))
    assert first.close()
    again = WorkspaceDatabase.open(tmp_path, "two")
    assert field_settings(again.settings(), field).dimensions == {"length": 101.3}
    store_dimensions(again, field)
    assert again.setting(DIMENSIONS_SETTING) is None
    assert not field_settings(again.settings(), field).dimensions
    again.close()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "cannot be read"),
        (json.dumps({"field": "soccer", "dimensions": {"length": "long"}}), "cannot be read"),
        (json.dumps({"field": "soccer", "dimensions": {"length": 30}}), "outside the range"),
        (json.dumps({"field": "soccer", "dimensions": {"lenght": 100}}), "no dimension"),
        (json.dumps({"field": "hockey", "dimensions": {"length": 60}}), ""),
    ],
)
def test_what_cannot_be_used_is_told_and_left(text, said):
    kept = field_settings({DIMENSIONS_SETTING: text}, load_field("soccer"))
    assert not kept.dimensions
    assert [said in problem for problem in kept.problems] == ([True] if said else [])


def test_a_field_says_what_is_not_nominal():
    field = load_field("soccer")
    assert (field.described, field.is_nominal) == ("soccer", True)
    sized = with_dimensions(field, {"length": 101.3, "width": 66.2})
    assert sized.described == "soccer 101.3 x 66.2 m"
    assert with_dimensions(field, {"width": 66.25}).described == "soccer 105 x 66.25 m"
    assert with_dimensions(sized, {}) == field
    with pytest.raises(FieldError, match="outside the range of the rules"):
        with_dimensions(field, {"length": 200.0})


def test_frames_that_cannot_be_read_take_no_part():
    def unreadable() -> FrameAnnotation:
        raise InputError("1.json", "is damaged")

    seen: list[tuple[int, int]] = []
    with pytest.raises(UsageError, match="no frame has a camera"):
        estimate_dimensions(
            {"1": unreadable, "2": FrameAnnotation},
            load_field("soccer"),
            size=(960, 540),
            progress=lambda done, total: seen.append((done, total)),
        )
    assert seen


# Which folder a dataset's own things lie in, however the dataset is named.


@pytest.fixture
def match(tmp_path) -> Path:
    folder = tmp_path / "match"
    (folder / "annotations").mkdir(parents=True)
    for name in ("1.png", "annotations/1.json", "match.mp4", "match.zip"):
        (folder / name).write_bytes(b"")
    return folder


def test_pictures_and_annotations_lead_to_their_folder(match):
    for place in ("", "1.png", "annotations", "annotations/1.json"):
        assert folder_of_dataset(match / place) == match
    assert folder_of_dataset(match / "match.mp4") == match / "match_frames"
    assert folder_of_dataset(match / "match.zip") is None
    assert folder_of_dataset(match / "nothing") is None


@pytest.mark.parametrize("own", ["field.toml", "landmarks.json", "views.csv", "2.png .procc/"])
def test_annotations_with_things_of_their_own_are_a_dataset(match, own):
    for name in own.split():
        path = match / "annotations" / name
        path.mkdir() if name.endswith("/") else path.write_bytes(b"")
    assert folder_of_dataset(match / "annotations") == match / "annotations"


def test_a_folder_is_that_of_the_one_video_annotated_in_it(tmp_path):
    for name in ("a.mp4", "b.MOV"):
        (tmp_path / name).write_bytes(b"")
    assert folder_of_dataset(tmp_path) == tmp_path
    for frames in ("a_frames", "b_frames"):
        (tmp_path / frames).mkdir()
    (tmp_path / "a_frames" / "a_000001.json").write_text("{}")
    assert folder_of_dataset(tmp_path) == tmp_path / "a_frames"
    (tmp_path / "b_frames" / "landmarks.json").write_text("{}")  # annotates nothing
    assert folder_of_dataset(tmp_path) == tmp_path / "a_frames"
    (tmp_path / "b_frames" / "b_000001.json").write_text("{}")
    assert folder_of_dataset(tmp_path) == tmp_path
    (tmp_path / "a_frames" / "a_000001.json").unlink()
    (tmp_path / "b_frames" / "b_000001.json").unlink()
    (tmp_path / "1.json").write_text("{}")
    assert folder_of_dataset(tmp_path) == tmp_path


# Which field the classes of a set belong to.

SOCCER = load_field("soccer")
CLASSES = [e.name for e in SOCCER.elements[:12]]


def other(*names: str):
    """A field that knows these classes."""
    elements = tuple(replace(SOCCER.elements[0], name=name) for name in names)
    return replace(SOCCER, name="other", title="Other", elements=elements, symmetries=())


def test_the_field_that_knows_most_comes_first():
    ranked = rank_fields([*CLASSES, "net"], [other("net", CLASSES[0])])
    assert [(m.title, m.known) for m in ranked if m.title in ("Soccer", "Other")] == [
        ("Soccer", 12),
        ("Other", 2),
    ]
    assert (ranked[0].title, ranked[0].known) == ("Soccer", 12)
    assert rank_fields(["nobody's class"]) == ()
    assert "soccer" in {m.name for m in rank_fields(["Goal left post left"])}  # spaces do not count


def test_among_equals_the_smaller_field_comes_first():
    small, large = other("net"), replace(other("net", "post"), title="Large")
    assert [m.title for m in rank_fields(["net"], [large, small])] == ["Other", "Large"]


def test_a_mismatch_names_the_field_that_fits():
    assert mismatch_of([*CLASSES, "Line unknown"], SOCCER) is None
    found = mismatch_of(CLASSES, other("net"))
    assert found.is_worth_reporting
    assert found.better.name == "soccer"
    assert found.words() == (
        "the field Other does not know any of the 12 classes annotated here"
        " (Big rect. left bottom, Big rect. left main, Big rect. left top, ...);"
        " Soccer knows all"
    )


def test_a_line_that_nobody_could_name_tells_no_sport():
    assert mismatch_of(["Line unknown", "Line unknown (2)"], load_field("tennis")) is None


def test_no_field_is_named_that_knows_no_more():
    found = mismatch_of([*CLASSES, "sponsor"], SOCCER)
    assert found.better is None
    assert not found.is_worth_reporting  # a slip of the pen in a soccer set
    mostly = mismatch_of([CLASSES[0], "sponsor", "net"], SOCCER)
    assert mostly.better is None
    assert mostly.is_worth_reporting
    alone = mismatch_of(["sponsor"], SOCCER)
    assert alone.is_worth_reporting
    assert alone.words() == (
        "the field Soccer does not know the one class annotated here (sponsor)"
    )


def test_a_field_that_knows_a_few_of_many_is_no_recommendation():
    padel = [f"padel {n}" for n in range(11)]
    found = mismatch_of([*padel, *CLASSES[:2]], other("net"))
    assert found.better is None  # soccer knows 2 of the 13
    assert found.is_worth_reporting
    found = mismatch_of([*padel, *CLASSES[:2]], other("net"), [other(*padel)])
    assert found.better.known == 11


def test_classes_are_those_with_points_of_frames_that_can_be_read():
    points = (Point(0.1, 0.1), Point(0.2, 0.2))

    def unreadable() -> FrameAnnotation:
        raise InputError("1.json", "is damaged")

    def one() -> FrameAnnotation:
        return FrameAnnotation((Polyline("a", points), Polyline("b", ())))

    def two() -> FrameAnnotation:
        return FrameAnnotation((Polyline("c", points),))

    assert classes_in([unreadable, one, FrameAnnotation, two]) == {"a", "c"}
    assert classes_in([one, two], most=1) == {"a"}


# The user's own copy of the sample: made once, whole, and left as they left it.


@pytest.fixture
def sample(tmp_path, monkeypatch) -> Path:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "data"))
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    folder = tmp_path / "sample"
    (folder / "cameras").mkdir(parents=True)
    (folder / "00001.json").write_text("{}")
    (folder / "cameras" / "a.json").write_text("{}")
    (folder / ".procc").mkdir()
    (folder / ".procc" / "workspace.db").write_text("somebody else's")
    return folder


def test_a_copy_is_made_and_kept(sample):
    own = copy_sample(sample)
    assert own != sample
    found = sorted(p.relative_to(own).as_posix() for p in own.rglob("*") if p.is_file())
    assert found == ["00001.json", "cameras/a.json"]
    (own / "00001.json").write_text('{"mine": []}')
    assert copy_sample(sample) == own
    assert (own / "00001.json").read_text() == '{"mine": []}'
    assert (sample / "00001.json").read_text() == "{}"
    assert [p.name for p in own.parent.iterdir()] == ["sample"]


def test_a_copy_that_cannot_be_made_is_said_and_leaves_nothing(sample, monkeypatch):
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("shutil.copytree", full)
    with pytest.raises(SaveError, match="No space left on device"):
        copy_sample(sample)
    monkeypatch.undo()


def test_two_windows_at_once(sample, monkeypatch):
    import os

    replace = os.replace

    def late(begun: Path, own: Path) -> None:
        own.mkdir(parents=True)
        (own / "theirs.json").write_text("{}")
        replace(begun, own)  # fails: it is there and not empty

    monkeypatch.setattr("os.replace", late)
    own = copy_sample(sample)
    assert (own / "theirs.json").exists()
