"""Elements not visible and settings outlive the program, damage and vanished folders."""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Status

Open = Callable[[], WorkspaceDatabase]
CIRCLE, LEFT = "Circle central", "Circle left"


@pytest.fixture(autouse=True)
def own_data(tmp_path_factory, monkeypatch) -> Path:
    """The user's data folder, out of the way."""
    folder = tmp_path_factory.mktemp("own")
    for name in ("XDG_DATA_HOME", "LOCALAPPDATA", "HOME"):
        monkeypatch.setenv(name, str(folder))
    return folder


@pytest.fixture
def dataset(tmp_path) -> Path:
    folder = tmp_path / "set"
    folder.mkdir()
    return folder


@pytest.fixture
def opened(dataset) -> Iterator[Open]:
    held: list[WorkspaceDatabase] = []

    def open_() -> WorkspaceDatabase:
        held.append(WorkspaceDatabase.open(dataset, "Anna"))
        return held[-1]

    yield open_
    for one in held:
        one.close()


def path_of(dataset: Path) -> Path:
    return dataset / ".procc" / "workspace.db"


class TestNotVisible:
    def test_they_are_there_again_with_who_and_when(self, opened) -> None:
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

    def test_saying_it_twice_keeps_who_said_it_first(self, opened) -> None:
        database = opened()
        database.set_not_visible("f1", CIRCLE, True)
        first = database.is_marked_not_visible("f1")[CIRCLE]
        database.author = "Ben"
        database.set_not_visible("f1", CIRCLE, True)
        assert database.is_marked_not_visible("f1")[CIRCLE] == first

    def test_another_window_sees_them_and_that_they_are_gone(self, opened) -> None:
        mine, theirs = opened(), opened()
        for hidden in (True, False):
            mine.set_not_visible("f1", CIRCLE, hidden)
            assert mine.flush()
            assert "f1" in theirs.reload()
            assert theirs.not_visible("f1") == mine.not_visible("f1")

    def test_a_database_of_the_version_before_goes_on(self, dataset, opened) -> None:
        database = opened()
        database.set_status("f1", Status.DONE)
        database.close()
        with sqlite3.connect(path_of(dataset)) as older:
            older.execute("DROP TABLE not_visible")
            older.execute("PRAGMA user_version = 3")
        older.close()
        again = opened()
        assert again.notices == ()
        assert again.record("f1").status is Status.DONE
        again.set_not_visible("f1", CIRCLE, True)
        again.close()
        assert opened().not_visible("f1") == {CIRCLE}


class TestSettings:
    def test_they_are_there_again(self, opened) -> None:
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

    def test_they_have_nothing_to_do_with_what_else_is_kept_by_key(self, opened) -> None:
        database = opened()
        database.last_frame = "f1"
        assert database.setting("last frame of Anna") is None
        database.set_setting("last frame of Anna", "mine")
        assert database.last_frame == "f1"

    def test_another_window_sees_them_and_that_they_are_gone(self, opened) -> None:
        mine, theirs = opened(), opened()
        for value in ("104.3", "105", None):
            mine.set_setting("length", value)
            assert mine.flush()
            theirs.reload()
            assert theirs.setting("length") == value


def test_they_are_written_into_a_file_begun_anew(dataset, opened) -> None:
    database = opened()  # as it was left by the session before
    database.set_not_visible("f1", CIRCLE, True)
    database.set_setting("length", "104.3")
    database.close()
    database = opened()
    database.set_not_visible("f1", LEFT, True)
    database.set_setting("width", "68")
    assert database.flush()
    (dataset / ".procc").rename(dataset / "gone")
    database.set_not_visible("f2", CIRCLE, True)
    assert database.flush()
    database.close()
    again = opened()
    assert again.not_visible("f1") == {CIRCLE, LEFT}
    assert again.not_visible("f2") == {CIRCLE}
    assert (again.setting("length"), again.setting("width")) == ("104.3", "68")


def test_what_was_said_and_taken_back_while_the_folder_was_gone(dataset, opened) -> None:
    database = opened()
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
    again = opened()
    assert "taken over" in again.notices[0]
    assert again.not_visible("f1") == {CIRCLE}
    assert again.not_visible("f2") == {CIRCLE}
    assert (again.setting("length"), again.setting("width")) == ("104.3", None)
