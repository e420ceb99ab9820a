"""The workspace's memory keeps what it was told through crashes, damage and vanished folders."""

import os
import random
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from procc_annotator.dataset.database import connection as database_file
from procc_annotator.dataset.database import database as database_module
from procc_annotator.dataset.database import writer as database_writer
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.database.location import read_settings
from procc_annotator.dataset.records import FrameRecord, Origin, OriginKind, Status, default_author
from procc_annotator.errors import InputError

Open = Callable[..., WorkspaceDatabase]
ODD_NAMES = ["", "a b", "Ä" * 300, "fr\udcff.1", "\ud800", "nul\0nul", "'; DROP TABLE frame; --"]


def _origin(time: float = 5.0) -> Origin:
    return Origin(OriginKind.SNAPPED, "Anna", time)


def _fill(database: WorkspaceDatabase) -> None:
    for i in range(40):
        database.set_status(f"f{i}", list(Status)[i % 5])
        database.put_origins(f"f{i}", {(i / 40, 0.25): _origin(float(i))})
        database.add_version(f"f{i}", b"version " * i, "saved")
        database.add_seconds(f"f{i}", i + 0.5)
    database.add_comment("f1", "look at the left goal", (3.0, 4.5))
    database.set_draft("f2", b"{}")
    database.last_frame = "f3"
    assert database.flush(20)


def _assert_filled(database: WorkspaceDatabase) -> None:
    assert database.record("f39") == FrameRecord(list(Status)[4], False, 39.5)
    goal = ("look at the left goal", (3.0, 4.5))
    assert [(c.text, c.place) for c in database.comments("f1")] == [goal]
    assert database.draft("f2") == b"{}"
    assert database.last_frame == "f3"
    assert database.origins("f7") == {(7 / 40, 0.25): _origin(7.0)}
    (version,) = database.versions("f7")
    assert database.version_data(version.id) == b"version " * 7


@pytest.mark.parametrize("frame", ODD_NAMES)
def test_everything_comes_back(opened, frame):
    first = opened()
    assert first.notices == ()
    assert first.record(frame) == FrameRecord()
    first.set_status(frame, Status.REJECTED)
    first.commit(frame)
    first.add_seconds(frame, 1.5)
    first.add_seconds(frame, 2.0)
    comment = first.add_comment(frame, "odd \udcff\0 text", (12.5, 700.0))
    first.put_origins(frame, {(0.1 + 0.2, -1e-300): _origin()})
    first.put_origins(frame, {(0.1 + 0.2, -1e-300): _origin(9.0), (2.0, 3.0): _origin()})
    first.set_draft(frame, b"\0draft")
    first.add_version(frame, b"one", "why \udcff")
    first.last_frame = frame
    known = first.record(frame)
    assert first.close()
    assert first.problem == ""

    again = opened()
    assert again.notices == ()
    assert again.record(frame) == known == FrameRecord(Status.REJECTED, True, 3.5, 1, 1)
    assert dict(again.records()) == {frame: known}
    assert again.comments(frame) == (comment,)
    assert again.comment_text(frame) == "odd \udcff\0 text"
    assert again.origins(frame) == {(0.1 + 0.2, -1e-300): _origin(9.0), (2.0, 3.0): _origin()}
    assert again.draft(frame) == b"\0draft"
    assert again.drafts() == (frame,)
    assert again.last_frame == frame
    (version,) = again.versions(frame)
    assert (version.frame, version.author, version.reason) == (frame, "Anna", "why \udcff")
    assert again.version_data(version.id) == b"one"
    again.set_draft(frame, None)
    again.resolve_comment(comment.id, True)
    again.resolve_comment("no such", True)
    assert again.record(frame).open_comments == 0
    again.close()

    third = opened()
    assert third.drafts() == ()
    assert third.record(frame).comments == 1
    assert third.comments(frame)[0].resolved
    assert third.comments(frame)[0].place == (12.5, 700.0)


def test_last_frame_belongs_to_the_author(opened):
    anna = opened()
    anna.last_frame = "f1"
    anna.close()
    assert opened(author="Bert").last_frame is None
    assert opened().last_frame == "f1"


def _newest(database: WorkspaceDatabase, frame: str) -> bytes:
    return database.version_data(database.versions(frame)[0].id)


def test_versions_are_ordered_as_written_whatever_the_clock_says(opened, monkeypatch):
    clock = iter([100.0, 50.0, 75.0, 1.0, 0.5, 0.25])
    monkeypatch.setattr(database_module.time, "time", lambda: next(clock))
    database = opened()
    for data in (b"a", b"b", b"b", b"a"):
        database.add_version("f", data, "saved")
    assert _newest(database, "f") == b"a"
    for text in ("first", "second"):
        database.add_comment("f", text)
    kept = [database.version_data(version.id) for version in database.versions("f")]
    assert kept == [b"a", b"b", b"a"]
    assert [version.time for version in database.versions("f")] == [1.0, 50.0, 100.0]
    database.close()
    again = opened()
    assert [comment.text for comment in again.comments("f")] == ["first", "second"]
    assert _newest(again, "f") == b"a"
    assert again.versions("g") == ()


def test_time_never_runs_backwards(opened):
    database = opened()
    for seconds in (-5.0, 0.0, float("nan"), float("inf"), 2.0):
        database.add_seconds("f", seconds)
    assert database.record("f").seconds == 2.0


def test_points_that_are_no_numbers_are_left_out(opened):
    database = opened()
    database.put_origins("f", {(float("nan"), 0.0): _origin(), (0.0, float("inf")): _origin()})
    database.put_origins("f", {(1, 2): _origin()})
    assert database.flush(20)
    assert database.origins("f") == {(1.0, 2.0): _origin()}


def test_origins_read_by_another_thread_are_no_word_on_what_comes_later(
    tmp_path, opened, monkeypatch
):
    first, other = opened(tmp_path), opened(tmp_path)
    answer = WorkspaceDatabase._answer

    def clicked_meanwhile(self: WorkspaceDatabase, future: Future[object]) -> object:
        read = answer(self, future)
        first.put_origins("1", {(0.5, 0.5): _origin()})
        return read

    monkeypatch.setattr(WorkspaceDatabase, "_answer", clicked_meanwhile)
    with ThreadPoolExecutor(1) as pool:
        assert (0.5, 0.5) in pool.submit(first.read_origins, "1").result()
    monkeypatch.undo()
    assert set(first.origins("1")) == {(0.5, 0.5)}
    other.put_origins("1", {(0.25, 0.5): _origin()})
    other.flush()
    assert set(first.read_origins("1")) == {(0.5, 0.5), (0.25, 0.5)}
    assert set(first.origins("1")) == {(0.5, 0.5)}  # until the window looks again


def test_unknown_version(opened):
    with pytest.raises(InputError, match="no such version"):
        opened().version_data("none")


def test_single_picture_has_the_database_of_its_folder(tmp_path, opened):
    picture = tmp_path / "f1.png"
    picture.write_bytes(b"")
    assert opened(picture).path == opened(tmp_path).path == tmp_path / ".procc" / "workspace.db"


# Circumstances


def test_folder_that_cannot_be_written(tmp_path, opened, own_data):
    blocked = tmp_path / "blocked"
    blocked.mkdir()
    (blocked / ".procc").write_bytes(b"")  # a file where the folder belongs
    database = opened(blocked)
    assert database.path.is_relative_to(own_data)
    (notice,) = database.notices
    assert str(database.path) in notice
    assert "\n" not in notice
    _fill(database)
    database.close()
    _assert_filled(opened(blocked))
    other = tmp_path / "elsewhere" / "blocked"
    other.mkdir(parents=True)
    (other / ".procc").write_bytes(b"")
    assert dict(opened(other).records()) == {}


def test_write_protected_dataset(tmp_path, opened, own_data, monkeypatch):
    earlier = opened()
    _fill(earlier)
    earlier.close()
    real = os.access
    monkeypatch.setattr(
        database_file.os,
        "access",
        lambda path, mode: not str(path).startswith(str(tmp_path)) and real(path, mode),
    )
    database = opened()
    assert database.path.is_relative_to(own_data)
    assert "write-protected" in database.notices[0]
    _assert_filled(database)
    database.set_status("f39", Status.REJECTED)
    database.close()
    again = opened()
    assert again.path == database.path
    assert again.record("f39").status is Status.REJECTED
    again.close()
    monkeypatch.setattr(database_file.os, "access", real)
    writable = opened()
    assert writable.path == tmp_path / ".procc" / "workspace.db"
    assert writable.record("f39") == FrameRecord(Status.REJECTED, False, 39.5)
    writable.close()
    assert opened().notices == ()


def _pictures(dataset: Path, first: int, size: int) -> None:
    dataset.mkdir(exist_ok=True, parents=True)
    for i in range(first, first + 40):
        (dataset / f"{i:05d}.jpg").write_bytes(b"x" * (size + i))


@pytest.mark.parametrize("below", ["", "league/game"])
def test_another_dataset_at_the_same_path_inherits_nothing(tmp_path, opened, own_data, below):
    drive = tmp_path / "drive"
    _pictures(drive / below, 0, 1000)
    (drive / ".procc").write_bytes(b"")  # nothing can be written there
    database = opened(drive)
    _fill(database)
    database.close()
    drive.rename(tmp_path / "unplugged")
    _pictures(drive / below, 0, 5000)  # the same names, other pictures
    (drive / ".procc").write_bytes(b"")
    other = opened(drive)
    assert dict(other.records()) == {}
    other.close()
    assert len(list(own_data.rglob("workspace*.db"))) == 2
    drive.rename(tmp_path / "second")
    (tmp_path / "unplugged").rename(drive)
    _assert_filled(opened(drive))


def test_a_dataset_that_gained_and_lost_pictures_is_still_the_same(tmp_path, opened):
    drive = tmp_path / "drive"
    _pictures(drive, 0, 1000)
    (drive / ".procc").write_bytes(b"")
    database = opened(drive)
    _fill(database)
    database.close()
    _pictures(drive, 40, 1000)
    for i in range(10):
        (drive / f"{i:05d}.jpg").unlink()
    _assert_filled(opened(drive))


def test_links_out_of_the_dataset_are_not_followed(tmp_path, opened, own_data):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    for i, name in enumerate((".procc", ".procc/workspace.db", ".procc/workspace.db-journal")):
        dataset = tmp_path / f"dataset {i}"
        link = dataset / name
        link.parent.mkdir(parents=True)
        link.symlink_to(elsewhere / "victim" if i else elsewhere)
        database = opened(dataset)
        assert database.path.is_relative_to(own_data)
        assert "leads out of the dataset" in database.notices[0]
        database.set_status("f", Status.DONE)
        database.close()
        assert list(elsewhere.iterdir()) == []


def test_nowhere_to_write(tmp_path, opened, monkeypatch):
    blocked = tmp_path / "file"
    blocked.write_bytes(b"")
    for name in ("XDG_DATA_HOME", "LOCALAPPDATA", "HOME"):
        monkeypatch.setenv(name, str(blocked / "below"))
    (tmp_path / ".procc").write_bytes(b"")
    database = opened()
    assert database.path is None
    assert "memory only" in database.notices[-1]
    _fill(database)
    _assert_filled(database)


def test_folder_deleted_under_the_open_database(tmp_path, opened):
    earlier = opened()
    earlier.set_status("old", Status.APPROVED)
    earlier.add_seconds("old", 7.0)
    earlier.add_comment("old", "kept")
    earlier.close()

    database = opened()
    _fill(database)
    database.add_seconds("old", 1.0)
    assert database.flush(20)
    (tmp_path / ".procc").rename(tmp_path / "gone")
    database.set_status("new", Status.DONE)
    assert database.flush(20)
    database.close()
    again = opened()
    _assert_filled(again)
    assert again.record("new").status is Status.DONE
    assert again.record("old") == FrameRecord(Status.APPROVED, False, 8.0, 1, 1)
    assert again.notices == ()


def test_drive_unplugged_and_back(tmp_path, opened):
    dataset, away = tmp_path / "drive", tmp_path / "away"
    dataset.mkdir()
    database = opened(dataset)
    _fill(database)
    dataset.rename(away)
    database.set_status("new", Status.DONE)
    database.add_version("new", b"kept in memory", "saved")
    assert not database.flush(20)
    problem = database.problem
    assert "workspace.db" in problem
    assert "\n" not in problem
    assert not database.flush(20)
    assert database.problem == problem
    assert not dataset.exists()

    (version,) = database.versions("new")
    assert database.version_data(version.id) == b"kept in memory"
    database.put_origins("new", {(0.5, 0.5): _origin()})
    assert database.origins("new") == {(0.5, 0.5): _origin()}
    assert database.record("new").status is Status.DONE
    assert database.reload() == frozenset()

    away.rename(dataset)
    assert database.flush(20)
    assert database.problem == ""
    assert database.versions("new") == (version,)
    database.close()
    again = opened(dataset)
    _assert_filled(again)
    assert again.record("new").status is Status.DONE
    assert again.origins("new") == {(0.5, 0.5): _origin()}


def test_another_file_takes_the_place_of_the_database(tmp_path, opened):
    backup = opened(tmp_path)
    backup.set_status("backed up", Status.DONE)
    backup.close()
    copy = tmp_path / "copy.db"
    shutil.copy(tmp_path / ".procc" / "workspace.db", copy)
    database = opened(tmp_path)
    _fill(database)
    os.replace(copy, tmp_path / ".procc" / "workspace.db")
    database.set_status("new", Status.DONE)
    assert database.flush(20)
    again = opened(tmp_path)
    _assert_filled(again)
    assert again.record("backed up").status is Status.DONE
    assert again.record("new").status is Status.DONE


def test_full_disk(opened, monkeypatch):
    connect, room = database_file.connect, [40]

    def small(path: Path | None) -> sqlite3.Connection:
        connection = connect(path)
        connection.execute(f"PRAGMA max_page_count = {room[0]}")
        return connection

    monkeypatch.setattr(database_file, "connect", small)
    database = opened()
    data = random.Random(1).randbytes(400_000)
    database.add_version("f", data, "saved")
    assert not database.flush(20)
    assert "full" in database.problem
    (version,) = database.versions("f")
    assert database.version_data(version.id) == data
    database.set_status("f", Status.DONE)
    assert not database.flush(20)

    monkeypatch.setattr(database_writer, "_KEEPS_CONNECTION", frozenset())
    room[0] = 10_000
    assert not database.flush(20)  # lets go of the connection that has no room
    assert database.flush(20)
    assert database.problem == ""
    database.close()
    again = opened()
    assert again.version_data(again.versions("f")[0].id) == data
    assert again.record("f").status is Status.DONE


def test_locked_for_long(tmp_path, opened, monkeypatch):
    monkeypatch.setattr(database_file, "_BUSY_S", 0.05)
    database = opened()
    other = sqlite3.connect(tmp_path / ".procc" / "workspace.db", isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    database.set_status("f", Status.DONE)
    assert not database.flush(20)
    assert "locked" in database.problem
    assert database.origins("f") == {}
    other.execute("ROLLBACK")
    other.close()
    assert database.flush(20)
    assert database.problem == ""


def test_what_could_not_be_written_is_taken_over_the_next_time(tmp_path, opened, own_data):
    dataset, away = tmp_path / "drive", tmp_path / "away"
    dataset.mkdir()
    database = opened(dataset)
    _fill(database)
    database.set_status("reset", Status.DONE)
    assert database.flush(20)
    dataset.rename(away)
    database.set_status("reset", Status.UNTOUCHED)
    database.set_status("f", Status.DONE)
    database.add_version("f", b"late", "saved")
    database.resolve_comment(database.comments("f1")[0].id, True)
    database.set_draft("f2", None)
    database.add_seconds("f1", 2.0)
    assert database.close()
    assert str(own_data) in database.notices[-1]
    assert database.close()
    assert not dataset.exists()

    away.rename(dataset)
    again = opened(dataset)
    assert again.path == dataset / ".procc" / "workspace.db"
    assert "taken over" in again.notices[0]
    assert again.record("f").status is Status.DONE
    assert again.record("reset").status is Status.UNTOUCHED
    assert again.record("f1") == FrameRecord(Status.IN_PROGRESS, False, 3.5, 0, 1)
    assert again.record("f39").status is list(Status)[4]
    assert again.drafts() == ()
    assert again.version_data(again.versions("f")[0].id) == b"late"
    again.close()
    assert opened(dataset).notices == ()


def test_close_says_when_something_is_lost(tmp_path, opened, monkeypatch):
    dataset = tmp_path / "drive"
    dataset.mkdir()
    database = opened(dataset)
    _fill(database)  # written: nothing is put into the folder while it goes
    dataset.rename(tmp_path / "gone")
    for name in ("XDG_DATA_HOME", "LOCALAPPDATA", "HOME"):
        monkeypatch.setenv(name, str(tmp_path / "file" / "below"))
    (tmp_path / "file").write_bytes(b"")
    database.set_status("f", Status.DONE)
    assert not database.close()
    assert database.problem
    assert not database.flush(20)
    assert database.versions("f") == ()
    assert database.close() is False


# Two at once


def test_two_windows_see_each_other(opened):
    anna, bert = opened(), opened(author="Bert")
    _fill(anna)
    assert "f1" in bert.reload()
    assert dict(bert.records()) == dict(anna.records())
    assert bert.comments("f1") == anna.comments("f1")
    assert bert.reload() == frozenset()
    assert anna.reload() == frozenset()

    bert.resolve_comment(bert.comments("f1")[0].id, True)
    bert.set_draft("f2", None)
    bert.add_seconds("f1", 10.0)
    assert bert.flush(20)
    assert anna.reload() == {"f1", "f2"}
    assert anna.record("f1") == bert.record("f1")
    assert anna.record("f1").open_comments == 0
    assert anna.drafts() == ()
    assert anna.last_frame == "f3"
    assert bert.last_frame is None

    assert anna.origins("f7").keys() == {(7 / 40, 0.25)}
    bert.put_origins("f7", {(0.5, 0.5): _origin()})
    assert bert.flush(20)
    assert anna.origins("f7").keys() == {(7 / 40, 0.25)}  # not looked yet
    anna.reload()
    assert anna.origins("f7").keys() == {(7 / 40, 0.25), (0.5, 0.5)}


def test_poll_never_waits_and_finds_it_by_the_next_call(opened):
    anna, bert = opened(), opened(author="Bert")
    bert.set_status("f", Status.DONE)
    assert bert.flush(20)
    assert anna.poll() == frozenset()
    anna._looking.result(20)
    assert anna.poll() == {"f"}
    assert anna.record("f").status is Status.DONE


def test_a_look_that_was_outdated_is_followed_by_another_one_at_once(opened):
    anna, bert = opened(), opened(author="Bert")
    bert.set_setting("lock", "on")
    assert bert.flush(20)
    anna.poll()
    anna._looking.result(20)
    anna.set_status("f", Status.DONE)
    anna.collect()
    assert anna.setting("lock") is None
    anna._looking.result(20)
    anna.collect()
    assert anna.setting("lock") == "on"
    assert anna.changed_settings() == {"lock"}
    assert anna.changed_settings() == frozenset()
    assert not anna.looking


def test_looking_takes_back_nothing_that_was_changed_meanwhile(opened):
    anna, bert = opened(), opened(author="Bert")
    bert.set_status("f", Status.DONE)
    bert.set_status("g", Status.DONE)
    assert bert.flush(20)
    anna.poll()
    anna._looking.result(20)
    anna.set_status("f", Status.REJECTED)
    assert anna.poll() == frozenset()
    assert anna.record("f").status is Status.REJECTED
    assert anna.flush(20)
    anna.reload()
    assert anna.record("f").status is Status.REJECTED
    assert anna.record("g").status is Status.DONE


WRITE_MANY = """
import sys
from pathlib import Path
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Status
database = WorkspaceDatabase.open(Path(sys.argv[1]), sys.argv[2])
assert database.notices == (), database.notices
for i in range(int(sys.argv[3])):
    database.set_status(f"{sys.argv[2]}{i}", Status.DONE)
    database.add_seconds("both", 1.0)
    database.add_comment("both", f"{sys.argv[2]}{i}")
    database.add_version("both", f"{sys.argv[2]}{i}".encode() * 50, "saved")
    if i % 25 == 24:
        assert database.flush(60), database.problem
        print(i, flush=True)
assert database.close(60), database.problem
"""


def _writing(dataset: Path, author: str, count: int) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-c", WRITE_MANY, str(dataset), author, str(count)],
        stdout=subprocess.PIPE,
        text=True,
    )


def test_two_processes_write_at_once(tmp_path, opened):
    count = 200
    processes = [_writing(tmp_path, author, count) for author in ("Anna", "Bert")]
    for process in processes:
        process.communicate()
        assert process.returncode == 0
    database = opened()
    assert database.notices == ()
    assert len(database.records()) == 2 * count + 1
    assert database.record("both") == FrameRecord(
        Status.UNTOUCHED, False, 2.0 * count, 2 * count, 2 * count
    )
    texts = [comment.text for comment in database.comments("both")]
    for author in ("Anna", "Bert"):
        own = [text for text in texts if text.startswith(author)]
        assert own == [f"{author}{i}" for i in range(count)]
    assert len(database.versions("both")) == 2 * count


def test_killed_in_the_middle_of_writing(tmp_path, opened):
    process = _writing(tmp_path, "Anna", 100_000)
    last = -1
    while last < 1000:
        last = int(process.stdout.readline())
    process.kill()
    rest = process.stdout.read().splitlines()
    process.stdout.close()
    process.wait()
    last = int(rest[-1]) if rest else last
    database = opened()
    assert database.notices == ()
    for i in range(last + 1):
        assert database.record(f"Anna{i}").status is Status.DONE
    texts = [comment.text for comment in database.comments("both")]
    assert texts == [f"Anna{i}" for i in range(len(texts))]
    assert len(texts) > last
    assert database.version_data(database.versions("both")[0].id).startswith(b"Anna")


def test_program_that_forgets_to_close_ends_and_has_written(tmp_path, opened):
    script = WRITE_MANY.rpartition("assert")[0]
    subprocess.run(
        [sys.executable, "-c", script, str(tmp_path), "Anna", "10"], check=True, timeout=60
    )
    assert opened().record("Anna9").status is Status.DONE


# Damage


def _damaged(opened: Open, dataset: Path) -> tuple[WorkspaceDatabase, Path]:
    database = opened(dataset)
    assert database.path == dataset / ".procc" / "workspace.db"
    return database, database.path.with_name("workspace.db.damaged-1")


@pytest.mark.parametrize(
    "content", [b"no database " * 1000, b"x" * 100, b"SQLite format 3\0" + b"?" * 99]
)
def test_what_is_no_database_is_set_aside(tmp_path, opened, content):
    (tmp_path / ".procc").mkdir()
    path = tmp_path / ".procc" / "workspace.db"
    path.write_bytes(content)
    path.with_name("workspace.db-journal").write_bytes(b"old journal")
    database, aside = _damaged(opened, tmp_path)
    (notice,) = database.notices
    assert aside.name in notice
    assert aside.read_bytes() == content
    _fill(database)
    database.close()
    again = opened()
    assert again.notices == ()
    _assert_filled(again)


def test_database_of_another_program_is_set_aside(tmp_path, opened):
    (tmp_path / ".procc").mkdir()
    with sqlite3.connect(tmp_path / ".procc" / "workspace.db") as other:
        other.execute("CREATE TABLE theirs(x)")
    other.close()
    database, aside = _damaged(opened, tmp_path)
    assert "another program" in database.notices[0]
    assert aside.exists()


def test_database_of_a_newer_version_is_left_alone(tmp_path, opened, own_data):
    database = opened()
    _fill(database)
    database.close()
    path = tmp_path / ".procc" / "workspace.db"
    with sqlite3.connect(path) as newer:
        newer.execute("PRAGMA user_version = 99")
    newer.close()
    before = path.read_bytes()
    database = opened()
    assert database.path.is_relative_to(own_data)
    assert "newer version" in database.notices[0]
    assert path.read_bytes() == before


def test_header_that_forbids_writing_is_damage(tmp_path, opened):
    database = opened()
    _fill(database)
    database.close()
    with open(tmp_path / ".procc" / "workspace.db", "r+b") as file:
        file.seek(18)
        file.write(b"\x09")
    database, _ = _damaged(opened, tmp_path)
    assert "forbids writing" in database.notices[0]
    _assert_filled(database)


LOSSES: dict[str, Callable[[Path], object]] = {
    "is missing": Path.unlink,
    "is empty (0 bytes)": lambda path: os.truncate(path, 0),
    "damaged-1": lambda path: path.write_bytes(b"no database"),
    "could not be used": lambda path: os.truncate(path, path.stat().st_size // 2),
}


@pytest.mark.parametrize("how", LOSSES)
def test_lost_database_is_restored_from_its_backup(tmp_path, opened, how):
    database = opened()
    _fill(database)
    database.set_setting("length", "104.3")
    database.close()
    path = tmp_path / ".procc" / "workspace.db"
    LOSSES[how](path)
    before = sorted(os.listdir(path.parent))
    settings, told = read_settings(tmp_path)
    assert settings == {"length": "104.3"}
    assert "its backup of 20" in told
    assert sorted(os.listdir(path.parent)) == before  # a command that only reads mends nothing
    again = opened()
    (notice,) = again.notices
    assert how.partition(" (")[0] in notice
    assert "the backup of 20" in notice
    assert "40 frames with a status or comment, 1 comment, 40 versions" in notice
    _assert_filled(again)
    assert again.setting("length") == "104.3"
    again.close()
    assert opened().notices == ()
    assert not list(path.parent.glob("*.tmp"))


@pytest.mark.parametrize("backup", [b"", b"no backup"])
def test_lost_without_a_backup_is_told(tmp_path, opened, backup):
    database = opened()
    _fill(database)
    database.close()
    path = tmp_path / ".procc" / "workspace.db"
    os.truncate(path, 0)
    path.with_name("workspace.db.backup").unlink()
    assert "it has no backup" in read_settings(tmp_path)[1]
    if backup:
        path.with_name("workspace.db.backup").write_bytes(backup)
    database = opened()
    assert ("0 frames with" if backup else "it has no backup") in database.notices[0]
    _fill(database)
    database.close()
    assert opened().notices == ()


def test_damage_never_gets_into_the_backup(tmp_path, opened, monkeypatch):
    database = opened()
    _fill(database)
    database.close()
    path = tmp_path / ".procc" / "workspace.db"
    backup = path.with_name("workspace.db.backup")
    sound = backup.read_bytes()
    whole = database_file._CHECKED_WHOLE
    monkeypatch.setattr(database_file, "_CHECKED_WHOLE", 0)
    with sqlite3.connect(path) as raw:
        tables = "SELECT rootpage FROM sqlite_master WHERE name = 'version'"
        (page,) = raw.execute(tables).fetchone()
    raw.close()
    with open(path, "r+b") as file:
        file.seek(4096 * (page - 1))
        file.write(b"?" * 4096)
    opened().close()
    assert backup.read_bytes() == sound
    monkeypatch.setattr(database_file, "_CHECKED_WHOLE", whole)
    database = opened()
    assert "set aside" in database.notices[0]
    _assert_filled(database)


def test_what_is_not_damaged_is_recovered(tmp_path, opened):
    database = opened()
    _fill(database)
    for i in range(3, 6):
        database.set_not_visible(f"f{i}", "Circle central", True)
    database.set_setting("width", "68")
    database.set_setting("width", None)
    database.close()
    path = tmp_path / ".procc" / "workspace.db"
    path.with_name("workspace.db.backup").unlink()
    with sqlite3.connect(path) as raw:
        raw.execute("UPDATE frame SET status = 'odd' WHERE name = 'f6'")
        raw.execute("UPDATE origin SET kind = 'odd' WHERE frame = 'f6'")
        raw.execute("UPDATE not_visible SET time = 'noon' WHERE frame = 'f4'")
    raw.close()
    database, aside = _damaged(opened, tmp_path)
    assert aside.name in database.notices[0]
    _assert_filled(database)
    assert database.record("f6").status is Status.UNTOUCHED
    assert database.origins("f6") == {}
    assert len(database.versions("f6")) == 1
    assert [i for i in range(9) if database.not_visible(f"f{i}")] == [3, 5]
    assert database.setting("width") is None


def test_damage_found_while_working(tmp_path, opened):
    database = opened()
    _fill(database)
    path = tmp_path / ".procc" / "workspace.db"
    with sqlite3.connect(path) as raw:
        raw.execute("UPDATE origin SET kind = 'odd' WHERE frame = 'f5'")
    raw.close()
    assert database.origins("f5").keys() == {(5 / 40, 0.25)}  # this session knows
    database.set_status("f5", Status.REJECTED)
    assert database.flush(20)
    assert database.problem == ""
    assert "damaged-1" in database.notices[0]
    database.close()
    again = opened()
    _assert_filled(again)
    assert again.notices == ()
    assert again.record("f5") == FrameRecord(Status.REJECTED, False, 5.5)


def test_file_in_use_that_cannot_be_renamed_is_copied(tmp_path, opened, monkeypatch):
    def refuse(*_: object) -> None:
        raise PermissionError(13, "in use")

    monkeypatch.setattr(database_file.os, "rename", refuse)
    (tmp_path / ".procc").mkdir()
    (tmp_path / ".procc" / "workspace.db").write_bytes(b"no database")
    database, aside = _damaged(opened, tmp_path)
    assert aside.read_bytes() == b"no database"
    _fill(database)
    database.close()
    _assert_filled(opened())


def test_any_damage_is_named(tmp_path, opened):
    database = opened()
    _fill(database)
    database.close()
    original = (tmp_path / ".procc" / "workspace.db").read_bytes()
    chance = random.Random(20)
    for number in range(150):
        data = bytearray(original)
        for _ in range(chance.choice((1, 1, 3, 30))):
            # Most of a small database's meaning is in its first pages.
            at = chance.randrange(chance.choice((100, 4096, len(data))))
            data[at] = chance.randrange(256)
        if number % 10 == 0:
            del data[chance.randrange(len(data)) :]
        dataset = tmp_path / f"dataset {number}"
        (dataset / ".procc").mkdir(parents=True)
        (dataset / ".procc" / "workspace.db").write_bytes(data)
        assert _newest_after_use(WorkspaceDatabase.open(dataset, "Anna"), dataset) == b"new"


def _newest_after_use(database: WorkspaceDatabase, dataset: Path) -> bytes:
    """Read, write, close, open again: what a frame's newest version then is."""
    for i in (0, 7, 39):
        database.origins(f"f{i}")
        for version in database.versions(f"f{i}"):
            try:
                database.version_data(version.id)
            except InputError as error:
                assert "damaged" in str(error) or "cannot be read" in str(error)  # noqa: PT017
    for i in range(40):
        database.add_version(f"f{i}", b"new", "saved")
    database.set_status("new", Status.DONE)
    database.put_origins("new", {(0.5, 0.5): _origin()})
    written = database.flush(20) or database.flush(20)
    assert written, database.problem
    assert database.close()
    again = WorkspaceDatabase.open(dataset, "Anna")
    assert again.record("new").status is Status.DONE
    assert again.origins("new") == {(0.5, 0.5): _origin()}
    newest = _newest(again, "f39")
    assert again.close()
    return newest


def test_author_comes_from_the_environment_or_the_login(monkeypatch):
    monkeypatch.setenv("PROCC_AUTHOR", "  Anna ")
    assert default_author() == "Anna"
    monkeypatch.setenv("PROCC_AUTHOR", "")
    monkeypatch.setenv("LOGNAME", "bert")
    assert default_author() == "bert"
    for name in ("LOGNAME", "USER", "LNAME", "USERNAME"):
        monkeypatch.delenv(name, raising=False)

    def nobody(_: int) -> object:
        raise KeyError("uid not found")

    pwd = pytest.importorskip("pwd")
    monkeypatch.setattr(pwd, "getpwuid", nobody)
    assert default_author() == "unknown"


def test_origins_that_were_foreseen_need_no_waiting(opened):
    first = opened()
    first.put_origins("a", {(0.25, 0.5): _origin()})
    first.close()
    database = opened()
    database.prefetch_origins(["a", "b"])
    database.put_origins("a", {(0.5, 0.5): _origin(7.0)})  # after the question, before the answer
    assert database.flush()
    database._writer.submit = pytest.fail
    assert database.origins("a") == {(0.25, 0.5): _origin(), (0.5, 0.5): _origin(7.0)}
    assert database.origins("b") == {}
    database.prefetch_origins(["a", "b"])  # known: nothing is asked
