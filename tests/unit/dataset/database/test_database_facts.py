"""Elements not visible, settings and verdicts outlive the program, damage and vanished folders."""

import sqlite3
import time
from pathlib import Path

import pytest

from procc_annotator.dataset.database.location import (
    fingerprint_of,
    fingerprints_match,
    matches_folder,
)
from procc_annotator.dataset.database.schema import MIGRATIONS, stored
from procc_annotator.dataset.records import FaultParty, Status, path_of, place_by_name, place_of

CIRCLE, LEFT = "Circle central", "Circle left"
BAD = "auto:cameras/bad"


def file_of(dataset: Path) -> Path:
    return dataset / ".procc" / "workspace.db"


class TestNotVisible:
    def test_they_are_there_again_with_who_and_when(self, opened):
        before = time.time()
        database = opened()
        database.set_not_visible("f1", CIRCLE, True)
        database.set_not_visible("f1", LEFT, True)
        database.set_not_visible("f\udcff2", "odd \udcff class", True)
        database.set_not_visible("f3", CIRCLE, True)
        database.set_not_visible("f3", CIRCLE, False)
        assert database.not_visible("f1") == {CIRCLE, LEFT}
        database.close()
        again = opened()
        assert again.not_visible("f1") == {CIRCLE, LEFT}
        assert again.not_visible("f\udcff2") == {"odd \udcff class"}
        assert again.not_visible("f3") == again.not_visible("never") == frozenset()
        mark = again.is_marked_not_visible("f1")[CIRCLE]
        assert (mark.frame, mark.class_name, mark.author) == ("f1", CIRCLE, "Anna")
        assert before <= mark.time <= time.time()

    def test_saying_it_twice_keeps_who_said_it_first(self, opened):
        database = opened()
        database.set_not_visible("f1", CIRCLE, True)
        first = database.is_marked_not_visible("f1")[CIRCLE]
        database.author = "Ben"
        database.set_not_visible("f1", CIRCLE, True)
        assert database.is_marked_not_visible("f1")[CIRCLE] == first

    def test_a_database_of_the_version_before_goes_on(self, tmp_path, opened):
        database = opened()
        database.set_status("f1", Status.DONE)
        database.close()
        with sqlite3.connect(file_of(tmp_path)) as older:
            older.execute("DROP TABLE not_visible")
            older.execute("DROP TABLE comment_place")
            older.execute("PRAGMA user_version = 3")
        older.close()
        again = opened()
        assert again.notices == ()
        assert again.record("f1").status is Status.DONE
        again.set_not_visible("f1", CIRCLE, True)
        again.close()
        assert opened().not_visible("f1") == {CIRCLE}


class TestSettings:
    def test_they_are_there_again(self, opened):
        database = opened()
        assert database.setting("length") is None
        database.set_setting("length", "104.3")
        database.set_setting("odd \udcff", "\udcff\0 text")
        database.set_setting("empty", "")
        database.set_setting("width", "68")
        database.set_setting("width", None)
        database.set_setting("never", None)
        database.last_frame = "f1"
        database.close()
        again = opened()
        assert again.setting("length") == "104.3"
        assert again.setting("odd \udcff") == "\udcff\0 text"
        assert again.setting("empty") == ""
        assert again.setting("width") is None
        assert again.settings().keys() == {"length", "odd \udcff", "empty"}
        assert again.last_frame == "f1"

    def test_they_have_nothing_to_do_with_what_else_is_kept_by_key(self, opened):
        database = opened()
        database.last_frame = "f1"
        assert database.setting("last frame of Anna") is None
        database.set_setting("last frame of Anna", "mine")
        assert database.last_frame == "f1"


@pytest.mark.parametrize(
    ("put", "get", "values"),
    [
        (lambda d, v: d.set_not_visible("f1", CIRCLE, v), lambda d: CIRCLE in d.not_visible("f1"),
         (True, False)),
        (lambda d, v: d.set_setting("length", v), lambda d: d.setting("length"),
         ("104.3", "105", None)),
        (lambda d, v: d.set_verdict("f1", "NBJW", v),
         lambda d: next((v.fault for v in d.verdicts("f1").values()), None),
         (FaultParty.CAMERA, None)),
    ],
    ids=["not visible", "setting", "verdict"],
)  # fmt: skip
def test_another_window_sees_them_and_that_they_are_gone(opened, put, get, values):
    mine, theirs = opened(), opened()
    for value in values:
        put(mine, value)
        assert mine.flush()
        theirs.reload()
        assert get(theirs) == get(mine) == value


def test_they_are_written_into_a_file_begun_anew(tmp_path, opened):
    database = opened()  # as it was left by the session before
    database.set_not_visible("f1", CIRCLE, True)
    database.set_setting("length", "104.3")
    database.set_verdict("f1", "NBJW", FaultParty.CAMERA)
    database.close()
    database = opened()
    database.set_not_visible("f1", LEFT, True)
    database.set_setting("width", "68")
    assert database.flush()
    (tmp_path / ".procc").rename(tmp_path / "gone")
    database.set_not_visible("f2", CIRCLE, True)
    assert database.flush()
    database.close()
    again = opened()
    assert again.verdicts("f1")[place_by_name("NBJW")].fault is FaultParty.CAMERA
    assert again.not_visible("f1") == {CIRCLE, LEFT}
    assert again.not_visible("f2") == {CIRCLE}
    assert (again.setting("length"), again.setting("width")) == ("104.3", "68")


def test_what_was_said_and_taken_back_while_the_folder_was_gone(tmp_path, opened):
    dataset = tmp_path / "set"
    dataset.mkdir()
    database = opened(dataset)
    for name in (CIRCLE, LEFT):
        database.set_not_visible("f1", name, True)
    database.set_setting("length", "104.3")
    database.set_setting("width", "68")
    assert database.flush()
    away = dataset.rename(dataset.with_name("away"))
    database.set_not_visible("f1", LEFT, False)
    database.set_not_visible("f2", CIRCLE, True)
    database.set_setting("width", None)
    assert database.close()  # kept in the user's data folder
    away.rename(dataset)
    again = opened(dataset)
    assert "taken over" in again.notices[0]
    assert again.not_visible("f1") == {CIRCLE}
    assert again.not_visible("f2") == {CIRCLE}
    assert (again.setting("length"), again.setting("width")) == ("104.3", None)


class TestVerdicts:
    def test_verdicts_are_there_again(self, opened):
        database = opened()
        database.set_verdict("f1", "NBJW", FaultParty.CAMERA, "the roll is off")
        database.set_verdict("f1", "CARWC", FaultParty.FINE)
        database.set_verdict("f\udcff2", "NBJW", FaultParty.ANNOTATION)
        database.set_verdict("f3", "NBJW", FaultParty.FINE)
        database.set_verdict("f3", "NBJW", None)
        database.close()
        again = opened()
        first = again.verdicts("f1")
        assert first[place_by_name("NBJW")].fault is FaultParty.CAMERA
        assert first[place_by_name("NBJW")].comment == "the roll is off"
        assert first[place_by_name("NBJW")].author == "Anna"
        assert first[place_by_name("CARWC")].fault is FaultParty.FINE
        assert set(again.all_verdicts()) == {"f1", "f\udcff2"}

    def test_a_database_of_the_version_before_goes_on(self, tmp_path, opened):
        database = opened()
        database.set_status("f1", Status.DONE)
        database.add_comment("f1", "left goal")
        database.close()
        path = file_of(tmp_path)
        with sqlite3.connect(path) as older:  # as it was before there were verdicts
            older.execute("DROP TABLE source_verdict")
            older.execute("DROP TABLE not_visible")
            older.execute("DROP TABLE comment_place")
            older.execute("PRAGMA user_version = 1")
        older.close()
        assert len(MIGRATIONS) == 5
        again = opened()
        assert again.notices == ()
        assert again.record("f1").status is Status.DONE
        assert [(c.text, c.place) for c in again.comments("f1")] == [("left goal", None)]
        again.set_verdict("f1", "NBJW", FaultParty.ANNOTATION)
        again.close()
        assert opened().verdicts("f1")[place_by_name("NBJW")].fault is FaultParty.ANNOTATION

    def test_verdicts_by_name_of_the_version_before_go_on(self, tmp_path, opened):
        opened().close()
        self.make_older(file_of(tmp_path))
        again = opened()
        assert again.notices == ()
        assert again.verdicts("f1")[place_by_name("NBJW")].source == "NBJW"
        assert again.verdicts("f2")[place_by_name("N\udcff")].fault is FaultParty.FINE

    def test_verdicts_of_a_damaged_file_of_the_version_before_are_saved(self, tmp_path, opened):
        opened().close()
        path = file_of(tmp_path)
        self.make_older(path)
        with sqlite3.connect(path) as damaged:
            damaged.execute("DROP TABLE draft")
        damaged.close()
        again = opened()
        assert "set aside" in again.notices[0]
        assert again.verdicts("f1")[place_by_name("NBJW")].fault is FaultParty.CAMERA

    @staticmethod
    def make_older(path: Path) -> None:
        """As it was before sources were known by their places."""
        with sqlite3.connect(path) as older:
            older.execute("DROP TABLE source_verdict")
            older.execute("DROP TABLE not_visible")
            older.execute("DROP TABLE comment_place")
            for statement in MIGRATIONS[1]:
                older.execute(statement)
            for frame, source, fault in (("f1", "NBJW", "camera"), ("f2", "N\udcff", "fine")):
                row = (frame, stored(source), fault)
                older.execute("INSERT INTO verdict VALUES(?, ?, ?, 'Anna', 1.5, '')", row)
            older.execute("PRAGMA user_version = 2")
        older.close()

    def test_a_new_name_goes_to_the_file_and_to_other_windows(self, opened):
        mine, theirs = opened(), opened()
        mine.set_verdict("f1", "bad", FaultParty.CAMERA, place=BAD)
        mine.set_verdict("f2", "bad", FaultParty.FINE, place="auto:elsewhere/bad")
        mine.set_verdict("f3", "bad", FaultParty.FINE, "from before")  # only the name is known
        mine.rename_source(BAD, "bad", "vendor X")
        assert mine.flush()
        theirs.reload()
        mine.close()
        for database in (mine, theirs, opened()):
            assert database.verdicts("f1")[BAD].source == "vendor X"
            assert database.verdicts("f2")["auto:elsewhere/bad"].source == "bad"
            (moved,) = database.verdicts("f3").values()
            assert (moved.source, moved.place, moved.comment) == ("vendor X", BAD, "from before")

    def test_a_new_verdict_takes_the_place_of_one_by_name(self, opened):
        database = opened()
        database.set_verdict("f1", "bad", FaultParty.FINE)
        database.set_verdict("f1", "bad", FaultParty.CAMERA, place=BAD)
        assert [v.fault for v in database.verdicts("f1").values()] == [FaultParty.CAMERA]

    def test_places(self, tmp_path):
        dataset = tmp_path / "set" / "images"
        for path, place in (
            (dataset / "cameras" / "bad", "auto:cameras/bad"),
            (dataset.parent / "cameras", "auto:../cameras"),
            (tmp_path / "bad", f"auto:{(tmp_path / 'bad').resolve().as_posix()}"),
        ):
            assert place_of(path, "auto", dataset) == place
            assert path_of(place) == place.removeprefix("auto:")
        assert path_of(place_by_name("bad")) == ""


# What is remembered of one dataset is not told of another at the same path.


def test_videos_tell_datasets_apart(tmp_path):
    for match, content in (("a", b"one half"), ("b", b"another half")):
        (tmp_path / match).mkdir()
        (tmp_path / match / f"{match}.mp4").write_bytes(content)
    a, b = tmp_path / "a", tmp_path / "b"
    assert matches_folder(fingerprint_of(a), a)
    assert not matches_folder(fingerprint_of(a), b)
    assert not fingerprints_match(fingerprint_of(a), fingerprint_of(b))
