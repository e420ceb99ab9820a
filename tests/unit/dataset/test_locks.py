"""Locks between windows and machines: who edits what, and when a lock expires."""

import os
import shutil
import threading
from pathlib import Path

import pytest

from procc_annotator.dataset import locks as locks_module
from procc_annotator.dataset.locks import FrameLocks, locks_folder


@pytest.fixture
def folder(tmp_path) -> Path:
    return locks_folder(tmp_path)


def _only_lock(folder: Path) -> Path:
    (path,) = folder.glob("*.lock")
    return path


def _age(path: Path, seconds: float) -> None:
    moment = path.stat().st_mtime - seconds
    os.utime(path, (moment, moment))


def test_one_holds_the_other_is_told(folder):
    anna, bert = FrameLocks(folder, "Anna"), FrameLocks(folder, "Bert")
    assert anna.holder("f") is None
    assert anna.acquire("f") is None
    assert anna.acquire("f") is None
    assert anna.held == {"f"}
    assert anna.holder("f") is None

    for found in (bert.holder("f"), bert.acquire("f")):
        assert found.author == "Anna"
        assert found.host
        assert found.since > 0
        assert found.age < 60
    assert bert.held == frozenset()
    assert bert.acquire("g") is None

    bert.release("f")  # not his
    assert bert.holder("f") is not None
    anna.release("f")
    assert bert.acquire("f") is None
    assert anna.beat() == frozenset()


def test_release_all_leaves_nothing(folder):
    anna = FrameLocks(folder, "Anna")
    for frame in ("a", "b"):
        anna.acquire(frame)
    anna.beat()
    anna.release_all()
    assert list(folder.iterdir()) == []
    assert anna.held == frozenset()


@pytest.mark.parametrize(
    "frame", ["a/b\\c:*?", "..", "", "\0", "ä" * 300, "fr\udcff", "con", "a" * 255, "x.lock"]
)
def test_any_name_can_be_locked(folder, frame):
    anna, bert = FrameLocks(folder, "Änn\udcff a"), FrameLocks(folder, "Bert")
    assert anna.acquire(frame) is None
    assert anna.held == {frame}
    assert _only_lock(folder).parent == folder
    assert bert.acquire(frame) is not None


def test_names_that_look_alike_are_told_apart(folder):
    anna, bert = FrameLocks(folder, "Anna"), FrameLocks(folder, "Bert")
    anna.acquire("a b")
    assert bert.holder("a_b") is None
    assert bert.holder("a  b") is None


def test_a_lock_without_beats_expires(folder):
    far = FrameLocks(folder, "Far")
    far.acquire("f")
    anna = FrameLocks(folder, "Anna")
    _age(_only_lock(folder), 50)
    found = anna.acquire("f")
    assert 45 < found.age < 60

    assert far.beat() == frozenset()
    found = anna.holder("f")
    assert found.age < 45

    _age(_only_lock(folder), 61)
    assert anna.holder("f") is None
    assert anna.acquire("f") is None
    assert far.beat() == {"f"}
    assert far.held == frozenset()
    far.release("f")
    assert far.holder("f") is not None
    assert anna.beat() == frozenset()


def test_wrong_clocks_do_not_matter(folder, monkeypatch):
    far = FrameLocks(folder, "Far")
    monkeypatch.setattr(locks_module.time, "time", lambda: 1.0)
    far.acquire("f")
    monkeypatch.setattr(locks_module.time, "time", lambda: 9e9)
    anna = FrameLocks(folder, "Anna")
    assert anna.acquire("f") is not None
    _age(_only_lock(folder), -3600)  # the server's clock was set back by an hour
    assert anna.acquire("f") is None


GARBAGE = [
    *(b"", b"{", b"[" * 4000, b"\xff\xfe", b"{}", b"[1]", b'{"session": 3}', b"x" * 10000),
    *(b'{"session": "s", "since": 1e999}', b'{"session":"s","author":"a","host":"h","since":"x"}'),
]


@pytest.mark.parametrize("content", GARBAGE)
def test_unreadable_lock_goes_by_its_age(folder, content):
    anna = FrameLocks(folder, "Anna")
    anna.acquire("f")
    path = _only_lock(folder)
    path.write_bytes(content)
    bert = FrameLocks(folder, "Bert")
    found = bert.acquire("f")
    assert found.author == ""
    assert anna.beat() == {"f"}
    _age(path, 61)
    assert bert.acquire("f") is None
    assert bert.held == {"f"}


def test_a_full_disk_leaves_no_lock_behind(folder):
    resource = pytest.importorskip("resource")
    FrameLocks(folder, "Anna").acquire("other")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    anna = FrameLocks(folder, "Anna")
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, limits[1]))  # files may be made, not written
    try:
        anna.acquire("f")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert not anna.is_there("f")
    assert FrameLocks(folder, "Bert").acquire("f") is None


def test_text_of_a_stranger_stays_in_one_line(folder):
    FrameLocks(folder, "An\nna " + "x" * 1000).acquire("f")
    found = FrameLocks(folder, "Bert").holder("f")
    assert found.author.startswith("An na x")
    assert len(found.author) <= 200


def test_removed_lock_is_lost(folder):
    anna = FrameLocks(folder, "Anna")
    anna.acquire("f")
    anna.acquire("g")
    for path in folder.glob("f-*.lock"):
        path.unlink()
    assert not anna.is_there("f")
    assert anna.beat() == {"f"}
    assert anna.held == {"g"}
    shutil.rmtree(folder.parent)
    assert anna.beat() == {"g"}


def test_folder_that_is_a_link_out_of_the_dataset_is_left_alone(tmp_path):
    elsewhere, dataset = tmp_path / "elsewhere", tmp_path / "dataset"
    elsewhere.mkdir()
    for link in (dataset / ".procc", dataset / ".procc" / "locks"):
        shutil.rmtree(dataset, ignore_errors=True)
        link.parent.mkdir(parents=True)
        link.symlink_to(elsewhere, target_is_directory=True)
        locks = FrameLocks(locks_folder(dataset), "Anna")
        assert locks.acquire("f") is None  # editing goes on, there is nothing to tell
        assert locks.held == frozenset()
        assert locks.beat() == frozenset()
        assert list(elsewhere.iterdir()) == []


def test_folder_out_of_reach_loses_nothing(folder):
    anna = FrameLocks(folder, "Anna")
    anna.acquire("f")
    dataset = folder.parent.parent
    away = dataset.with_name("away")
    dataset.rename(away)
    assert anna.beat() == frozenset()
    assert not dataset.exists()
    away.rename(dataset)
    assert anna.beat() == frozenset()
    assert anna.held == {"f"}


def test_what_cannot_be_written_tells_nothing(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_bytes(b"")
    for folder in (locks_folder(blocked / "dataset"), locks_folder(tmp_path / "gone")):
        anna = FrameLocks(folder, "Anna")
        assert anna.acquire("f") is None
        assert anna.held == frozenset()
        assert anna.holder("f") is None
        assert anna.beat() == frozenset()
        anna.release("f")
        anna.release_all()
    assert not (tmp_path / "gone").exists()


def test_read_only_folder_tells_who_holds(folder, monkeypatch):
    FrameLocks(folder, "Far").acquire("f")

    def refuse(path: Path, data: bytes) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(locks_module, "_create", refuse)
    anna = FrameLocks(folder, "Anna")
    assert anna.acquire("g") is None
    found = anna.holder("f")
    assert found.author == "Far"


def test_of_many_takers_one_gets_it(folder):
    rounds, takers = 40, 4
    dead = FrameLocks(folder, "Dead")
    names = [f"f{i}" for i in range(rounds)]
    for name in names:
        dead.acquire(name)
    for path in folder.glob("*.lock"):
        _age(path, 100)
    windows = [FrameLocks(folder, str(i)) for i in range(takers)]
    barrier = threading.Barrier(takers)

    def take(window: FrameLocks) -> None:
        for name in names:
            barrier.wait()
            window.acquire(name)

    threads = [threading.Thread(target=take, args=(window,)) for window in windows]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for window in windows:
        window.beat()  # of two who took one in the same moment one learns that it lost
    assert sorted(name for window in windows for name in window.held) == sorted(names)


def test_single_picture_shares_the_locks_of_its_folder(tmp_path):
    picture = tmp_path / "frame.png"
    picture.write_bytes(b"")
    assert locks_folder(picture) == locks_folder(tmp_path)
