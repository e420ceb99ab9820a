"""A dataset being worked on: listing, undo, and saves that never destroy anything."""

import json
import unicodedata
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset import editing, saving
from procc_annotator.dataset.editing import History
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import AnnotationError, ChangedOnDiskError, SaveError, UsageError
from procc_annotator.field.load import load_field

FIELD = load_field()
LINE = FrameAnnotation((Polyline("Middle line", (Point(0.5, 0.1), Point(0.5, 0.9))),))


def dataset(folder: Path, *pictures: str) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name in pictures:
        (folder / name).write_bytes(b"")
    return folder


def opened(folder: Path, annotations: Path | None = None) -> Workspace:
    return Workspace.open(folder, FIELD, annotations)


def test_pictures_in_natural_order_hidden_and_other_files_left_out(tmp_path):
    dataset(tmp_path, "10.jpg", "9.JPEG", "100.png", ".x.jpg", "notes.txt", "a.webp", "b.bmp")
    assert [f.name for f in opened(tmp_path).frames] == ["9", "10", "100", "a", "b"]


def test_two_pictures_of_one_name_would_share_a_file_so_one_is_left_out(tmp_path):
    dataset(tmp_path, "1.jpg", "1.png")
    found = opened(tmp_path)
    assert [f.image_path.name for f in found.frames] == ["1.jpg"]
    assert found.notices == ("1.png is left out: 1.jpg already is frame 1",)


def test_pictures_whose_annotations_would_pass_for_other_files(tmp_path):
    dataset(tmp_path, "1.jpg", "camera_1.jpg", "camera_2.jpg", "jac.png", "landmarks.png")
    found = opened(tmp_path)
    assert [f.name for f in found.frames] == ["1", "camera_1", "camera_2"]
    cameras, *left_out = found.notices
    assert cameras.startswith("camera_1.jpg and 1 more have names that files of cameras have")
    assert "rename" in cameras
    assert [notice.split(":")[0] for notice in left_out] == [
        "jac.png is left out",
        "landmarks.png is left out",
    ]


def test_where_annotations_lie(tmp_path):
    dataset(tmp_path, "1.jpg")
    assert opened(tmp_path).frames[0].annotation_path == tmp_path / "1.json"
    chosen = tmp_path / "elsewhere"
    assert opened(tmp_path, chosen).frames[0].annotation_path == chosen / "1.json"
    (tmp_path / "annotations").mkdir()
    assert opened(tmp_path).frames[0].annotation_path == tmp_path / "1.json"
    (tmp_path / "annotations" / "1.json").write_text("{}")
    assert opened(tmp_path).frames[0].annotation_path == tmp_path / "annotations" / "1.json"


@pytest.mark.parametrize("stem", ["A", "E\u0301"])
def test_an_annotation_keeps_the_suffix_it_has(tmp_path, stem):
    """Another file beside it would be a second annotation of the frame."""
    dataset(tmp_path, f"{unicodedata.normalize('NFC', stem)}.jpg", "B.jpg")
    written = tmp_path / f"{stem}.JSON"
    written.write_text('{"Middle line": [{"x": 0.5, "y": 0.1}, {"x": 0.5, "y": 0.9}]}')
    workspace = opened(tmp_path)
    at = next(i for i, frame in enumerate(workspace.frames) if frame.name != "B")
    assert workspace.read(at).annotated == ("Middle line",)
    workspace.edit(at, "x", editing.append_points(LINE, "Middle line", [Point(0.2, 0.2)]))
    workspace.save(at)
    assert sorted(path.name for path in tmp_path.glob("*.[jJ]*[nN]")) == [written.name]
    assert workspace.frames[1 - at].annotation_path.name == "B.json"


def test_annotations_that_another_folder_hides_are_not_hidden_silently(tmp_path):
    dataset(tmp_path, "1.jpg", "2.jpg")
    (tmp_path / "1.json").write_text("{}")
    (tmp_path / "jac.json").write_text("{}")
    assert opened(tmp_path).notices == ()
    (tmp_path / "annotations").mkdir()
    (tmp_path / "annotations" / "1.json").write_text("{}")
    assert opened(tmp_path).notices == (
        f"annotations are those in {tmp_path / 'annotations'}; 1 next to the pictures are not used",
    )
    assert opened(tmp_path, tmp_path / "annotations").notices == ()


def test_a_single_picture_and_what_is_none(tmp_path):
    dataset(tmp_path, "1.jpg", "2.jpg", "notes.txt")
    assert [f.name for f in opened(tmp_path / "2.jpg").frames] == ["2"]
    with pytest.raises(UsageError, match="not a picture"):
        opened(tmp_path / "notes.txt")
    with pytest.raises(UsageError, match="no such file or folder"):
        opened(tmp_path / "absent")


def test_an_edit_is_saved_and_read_again(tmp_path):
    dataset(tmp_path, "1.jpg")
    work = opened(tmp_path, tmp_path / "new" / "folder")
    assert work.edit(0, "draw", LINE)
    assert work.dirty_frames() == [0]
    work.save(0)
    assert work.dirty_frames() == []
    again = opened(tmp_path, tmp_path / "new" / "folder")
    assert again.state(0).history.current == LINE
    assert again.annotated_count(0) == 1


def test_taking_back_the_first_click_takes_the_file_away(tmp_path):
    dataset(tmp_path, "1.jpg")
    work = opened(tmp_path)
    work.save(0)
    assert not (tmp_path / "1.json").exists()
    work.edit(0, "draw", LINE)
    work.save(0)
    assert work.undo(0) == "draw"
    work.save(0)
    assert not (tmp_path / "1.json").exists()
    assert work.dirty_frames() == []
    assert work.annotation_to_score(0) is None
    assert work.redo(0) == "draw"
    work.save(0)
    assert opened(tmp_path).read(0) == LINE


def test_a_file_that_others_wrote_is_never_taken_away(tmp_path):
    dataset(tmp_path, "1.jpg", "2.jpg")
    (tmp_path / "1.json").write_text('{"Middle line": []}')
    work = opened(tmp_path)
    for index in (0, 1):
        work.edit(index, "draw", LINE)
        work.save(index)
    (tmp_path / "2.json").write_text("{}")  # the very content that taking back would leave
    for index in (0, 1):
        work.undo(index)
    work.save(0)
    with pytest.raises(ChangedOnDiskError):
        work.save(1)
    work.overwrite(1)
    for name in ("1.json", "2.json"):
        assert json.loads((tmp_path / name).read_text()) in ({}, {"Middle line": []})
    assert work.annotation_to_score(0) is not None


def test_a_file_changed_meanwhile_is_not_overwritten(tmp_path):
    dataset(tmp_path, "1.jpg")
    path = tmp_path / "1.json"
    path.write_text('{"Circle left": []}')
    work = opened(tmp_path)
    work.edit(0, "draw", LINE)
    path.write_text('{"Circle right": [{"x": 0.1, "y": 0.2}]}')
    with pytest.raises(ChangedOnDiskError, match="changed on disk meanwhile"):
        work.save(0)
    assert "Circle right" in path.read_text()
    assert work.state(0).dirty
    work.reload(0)
    assert work.state(0).history.current.annotated == ("Circle right",)
    assert not work.state(0).dirty
    assert work.undo(0) == "reload from disk"
    assert work.state(0).history.current == LINE
    work.save(0)
    assert "Middle line" in path.read_text()


def test_a_file_that_appeared_meanwhile_counts_as_changed(tmp_path):
    dataset(tmp_path, "1.jpg")
    work = opened(tmp_path)
    work.edit(0, "draw", LINE)
    (tmp_path / "1.json").write_text("{}")
    with pytest.raises(ChangedOnDiskError):
        work.save(0)
    work.overwrite(0)
    assert opened(tmp_path).read(0) == LINE


def test_a_folder_that_vanished_is_not_made_anew(tmp_path):
    folder = dataset(tmp_path / "drive", "1.jpg")
    work = opened(folder)
    work.edit(0, "draw", LINE)
    folder.rename(tmp_path / "unplugged")
    with pytest.raises(SaveError, match="could not be saved"):
        work.save(0)
    assert not folder.exists()
    (tmp_path / "unplugged").rename(folder)
    work.save(0)
    assert opened(folder).read(0) == LINE


def test_a_deleted_file_is_written_again(tmp_path):
    dataset(tmp_path, "1.jpg")
    (tmp_path / "1.json").write_text("{}")
    work = opened(tmp_path)
    work.edit(0, "draw", LINE)
    (tmp_path / "1.json").unlink()
    work.save(0)
    assert opened(tmp_path).read(0) == LINE


def test_a_folder_that_is_gone_for_a_while_takes_nothing_from_the_screen(tmp_path):
    folder = tmp_path / "drive"
    folder.mkdir()
    dataset(folder, "1.jpg")
    work = opened(folder)
    work.edit(0, "draw", LINE)
    work.save(0)
    folder.rename(tmp_path / "unplugged")
    assert not work.refresh(0)
    assert work.state(0).history.current == LINE
    (tmp_path / "unplugged").rename(folder)
    (folder / "1.json").unlink()
    assert work.refresh(0)
    assert not work.state(0).history.current.annotated


def test_a_failed_save_stays_dirty_and_keeps_the_old_file(tmp_path, monkeypatch):
    dataset(tmp_path, "1.jpg")
    (tmp_path / "1.json").write_text("{}")
    work = opened(tmp_path)
    work.edit(0, "draw", LINE)

    def full(path: Path, data: bytes, **_: object) -> None:
        raise SaveError(f"{path}: could not be saved: disk full")

    monkeypatch.setattr(saving, "write_atomic", full)
    with pytest.raises(SaveError, match="disk full"):
        work.save(0)
    assert work.dirty_frames() == [0]
    assert "disk full" in str(work.state(0).save_error)
    assert (tmp_path / "1.json").read_text() == "{}"
    monkeypatch.undo()
    work.save(0)
    assert work.state(0).save_error is None
    assert work.dirty_frames() == []


@pytest.mark.parametrize("content", ['{"Circle left": [{"x": NaN, "y": 1}]}', "{", ""])
def test_an_unreadable_annotation_blocks_its_frame_only(tmp_path, content):
    dataset(tmp_path, "1.jpg", "2.jpg")
    (tmp_path / "1.json").write_text(content)
    work = opened(tmp_path)
    assert isinstance(work.state(0).error, AnnotationError)
    with pytest.raises(UsageError, match="cannot be edited"):
        work.edit(0, "draw", LINE)
    work.save(0)
    assert (tmp_path / "1.json").read_text() == content
    with pytest.raises(AnnotationError):
        work.annotated_count(0)
    assert work.edit(1, "draw", LINE)
    (tmp_path / "1.json").write_text("{}")
    work.reload(0)
    assert work.state(0).error is None
    assert work.edit(0, "draw", LINE)


def test_a_blocked_frame_is_not_overwritten_even_on_request(tmp_path):
    dataset(tmp_path, "1.jpg")
    (tmp_path / "1.json").write_text("{ half a fil")
    work = opened(tmp_path)
    with pytest.raises(SaveError, match="could not be read"):
        work.overwrite(0)
    assert (tmp_path / "1.json").read_text() == "{ half a fil"


def test_a_repaired_frame_cannot_be_undone_to_an_emptiness_it_never_had(tmp_path):
    dataset(tmp_path, "1.jpg")
    path = tmp_path / "1.json"
    path.write_text("{")
    work = opened(tmp_path)
    assert work.state(0).error is not None
    path.write_text('{"Circle left": [{"x": 0.1, "y": 0.2}]}')
    work.reload(0)
    assert work.undo(0) is None
    assert work.state(0).history.current.annotated == ("Circle left",)
    assert work.dirty_frames() == []


def test_a_failed_reload_changes_nothing(tmp_path):
    dataset(tmp_path, "1.jpg")
    work = opened(tmp_path)
    work.edit(0, "draw", LINE)
    (tmp_path / "1.json").write_text("{")
    with pytest.raises(AnnotationError):
        work.reload(0)
    assert work.state(0).history.current == LINE
    with pytest.raises(ChangedOnDiskError):
        work.save(0)
    assert (tmp_path / "1.json").read_text() == "{"


def test_a_link_in_a_circle_does_not_end_the_listing(tmp_path):
    dataset(tmp_path, "1.jpg")
    (tmp_path / "2.jpg").symlink_to(tmp_path / "2.jpg")
    (tmp_path / "3.jpg").symlink_to(tmp_path / "nowhere.jpg")
    (tmp_path / "4.jpg").symlink_to(tmp_path / "1.jpg")
    assert [f.name for f in opened(tmp_path).frames] == ["1", "4"]


def test_a_folder_in_place_of_an_annotation(tmp_path):
    dataset(tmp_path, "1.jpg")
    (tmp_path / "1.json").mkdir()
    assert "is a folder" in str(opened(tmp_path).state(0).error)


coordinates = st.floats(-0.5, 1.5)
points = st.builds(lambda u, v: Point(u, v), coordinates, coordinates)
names = st.sampled_from(["Circle left", "Middle line", "Line unknown"])


@given(st.data())
def test_undoing_every_edit_gives_the_beginning_back(data):
    history = History(LINE)
    passed = [LINE]
    for _ in range(data.draw(st.integers(0, 15))):
        current, name = history.current, data.draw(names)
        polyline = current.get(name)
        size = len(polyline.points) if polyline else 0
        kind = data.draw(st.sampled_from(["append", "insert", "move", "delete", "clear"]))
        if kind == "append":
            edited = editing.append_points(current, name, [data.draw(points)])
        elif kind == "insert":
            at = data.draw(st.integers(0, size))
            edited = editing.insert_point(current, name, at, data.draw(points))
        elif kind == "clear":
            edited = current.without(name)
        elif size == 0:
            continue
        elif kind == "move":
            at = data.draw(st.integers(0, size - 1))
            edited = editing.move_point(current, name, at, data.draw(points))
        else:
            edited = editing.delete_point(current, name, data.draw(st.integers(0, size - 1)))
        if history.push(kind, edited):
            passed.append(edited)
    for expected in reversed(passed[:-1]):
        assert history.undo() is not None
        assert history.current == expected
    assert history.undo() is None
    for expected in passed[1:]:
        assert history.redo() is not None
        assert history.current == expected
    assert not history.can_redo


def test_a_new_edit_gives_up_what_was_undone():
    history = History(FrameAnnotation())
    history.push("draw", LINE)
    history.undo()
    history.push("other", editing.change_class(LINE, "Middle line", "Side line left"))
    assert (history.can_redo, history.undo_label) == (False, "other")
    assert not history.push("nothing", history.current)


def test_changing_a_class_keeps_its_place_and_refuses_a_taken_one():
    both = LINE.with_polyline(Polyline("Circle left", (Point(0, 0),)))
    changed = editing.change_class(both, "Middle line", "Side line left")
    assert changed.annotated == ("Side line left", "Circle left")
    with pytest.raises(ValueError, match="already annotated"):
        editing.change_class(both, "Middle line", "Circle left")
    with pytest.raises(ValueError, match="is not annotated"):
        editing.change_class(both, "Side line top", "Side line left")
    for call in (editing.delete_point, lambda a, n, i: editing.move_point(a, n, i, Point(0, 0))):
        with pytest.raises(IndexError):
            call(both, "Circle left", 1)


def test_moving_a_point_keeps_what_the_file_said_about_it():
    before = FrameAnnotation((Polyline("Circle left", (Point(0, 0, (("occluded", True),)),)),))
    moved = editing.move_point(before, "Circle left", 0, Point(0.5, 0.5))
    assert moved.polylines[0].points == (Point(0.5, 0.5, (("occluded", True),)),)


def test_somebody_elses_empty_file_is_not_removed_for_ours(tmp_path, monkeypatch):
    """Ours was to go away, nobody could see whether it did; theirs says: nothing is in sight."""
    dataset(tmp_path, "1.jpg")
    work, path = opened(tmp_path), tmp_path / "1.json"
    work.edit(0, "draw", LINE)
    work.save(0)
    work.undo(0)

    def unreadable(path: Path, error: type[AnnotationError]) -> bytes:
        raise error(str(path), "Input/output error")

    def fail(path: Path) -> None:
        broken.setattr(saving, "read_optional", unreadable)
        raise SaveError("Input/output error")

    with monkeypatch.context() as broken:
        broken.setattr(saving, "remove", fail)
        with pytest.raises(SaveError):
            work.save(0)
    assert work.state(0).dirty
    path.write_bytes(b"{}")
    with pytest.raises(ChangedOnDiskError):
        work.save(0)
    assert path.read_bytes() == b"{}"


def test_annotations_around_an_only_folder_may_be_composed_otherwise(tmp_path):
    (tmp_path / "img1").mkdir()
    (tmp_path / "img1/caf\u00e9.png").touch()
    (tmp_path / "cafe\u0301.json").write_text("{}")
    workspace = Workspace.open(tmp_path, load_field())
    assert workspace.has_file(0)
