"""Saving when the system fails: each call of `write_atomic`, each reason, the same promises."""

import errno
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.errors import SaveError
from procc_annotator.formats.atomic import write_atomic

OLD, NEW = b"old", b"the new content"
# Every function of the system that is called before the new file has the old one's name.
CALLS = ("stat", "access", "open", "fdopen", "fchmod", "fsync", "replace")
STREAM_CALLS = ("write", "flush", "close")
REASONS = {
    errno.ENOSPC: "make room",
    errno.EACCES: "permissions",
    errno.EIO: "check the drive",
    errno.ESTALE: "check the drive",
    errno.EROFS: "choose a folder that can be written to",
    errno.EBUSY: "try again",
}


class Stream:
    """A file of which one method fails."""

    def __init__(self, file: Any, broken: str, error: BaseException) -> None:
        self.file = file
        self.broken = broken
        self.error = error

    def __enter__(self):
        return self

    def __exit__(self, *_: object) -> None:
        self.file.close()
        self._maybe_fail("close")

    def write(self, data: bytes) -> None:
        self.file.write(data[:3] if self.broken == "write" else data)
        self._maybe_fail("write")

    def fileno(self) -> int:
        return int(self.file.fileno())

    def flush(self) -> None:
        self.file.flush()
        self._maybe_fail("flush")

    def _maybe_fail(self, name: str) -> None:
        if name == self.broken:
            raise self.error


def break_call(
    patch: pytest.MonkeyPatch, name: str, error: BaseException, after: bool = False
) -> None:
    """Let one call fail, before it has done anything or right after it has."""
    if name in STREAM_CALLS:
        fdopen = os.fdopen
        patch.setattr(os, "fdopen", lambda *a: Stream(fdopen(*a), name, error))
        return
    real: Callable[..., Any] = getattr(os, name)

    def fail(*args: Any, **options: Any) -> Any:
        if name == "stat" and Path(args[0]).name != "1.json":  # pytest looks at files as well
            return real(*args, **options)
        if after:
            real(*args, **options)
        raise error

    patch.setattr(os, name, fail)


@pytest.fixture
def path(tmp_path) -> Path:
    (tmp_path / "1.json").write_bytes(OLD)
    return tmp_path / "1.json"


def descriptors() -> int:
    folder = Path("/proc/self/fd")
    return len(list(folder.iterdir())) if folder.is_dir() else 0


@pytest.mark.parametrize("code", REASONS, ids=errno.errorcode.get)
@pytest.mark.parametrize("call", [*CALLS, *STREAM_CALLS])
def test_every_reason_at_every_call(path, monkeypatch, call, code):
    opened = descriptors()
    with monkeypatch.context() as patch:
        break_call(patch, call, OSError(code, os.strerror(code)))
        with pytest.raises(SaveError) as caught:
            write_atomic(path, NEW)
    text = str(caught.value)
    assert text.startswith(f"{path}: could not be saved: {os.strerror(code)} (")
    assert REASONS[code] in text
    assert len(text.splitlines()) == 1
    assert path.read_bytes() == OLD
    assert os.listdir(path.parent) == ["1.json"]
    assert descriptors() == opened


@pytest.mark.parametrize("call", [*CALLS, *STREAM_CALLS])
def test_an_interruption_at_every_call(path, monkeypatch, call):
    opened = descriptors()
    with monkeypatch.context() as patch:
        break_call(patch, call, KeyboardInterrupt())
        with pytest.raises(KeyboardInterrupt):
            write_atomic(path, NEW)
    assert path.read_bytes() == OLD
    assert os.listdir(path.parent) == ["1.json"]
    assert descriptors() == opened


@pytest.mark.parametrize("failure", [OSError(errno.EIO, "late"), KeyboardInterrupt()])
def test_a_rename_that_happened_and_yet_reports_a_failure(path, monkeypatch, failure):
    """A network drive may lose the answer: the file is then the new one, whole."""
    with monkeypatch.context() as patch:
        break_call(patch, "replace", failure, after=True)
        with pytest.raises((SaveError, KeyboardInterrupt)):
            write_atomic(path, NEW)
    assert path.read_bytes() == NEW
    assert os.listdir(path.parent) == ["1.json"]


def test_a_temporary_file_that_cannot_be_removed_hides_nothing(path, monkeypatch):
    with monkeypatch.context() as patch:
        break_call(patch, "fsync", OSError(errno.EIO, "Input/output error"))
        break_call(patch, "unlink", OSError(errno.EACCES, "Permission denied"))
        with pytest.raises(SaveError, match="Input/output error"):
            write_atomic(path, NEW)
    assert path.read_bytes() == OLD
    left = [name for name in os.listdir(path.parent) if name != "1.json"]
    assert len(left) == 1
    assert left[0].startswith(".procc-")
    write_atomic(path, NEW)
    assert path.read_bytes() == NEW


@pytest.mark.parametrize("call", ["open", "fsync", "close"])
def test_the_new_file_stays_when_only_its_folder_cannot_be_synced(path, monkeypatch, call):
    replace = os.replace
    with monkeypatch.context() as patch:

        def replace_and_break(*names: Any) -> None:
            replace(*names)
            break_call(patch, call, OSError(errno.EIO, "Input/output error"), after=call == "close")

        patch.setattr(os, "replace", replace_and_break)
        write_atomic(path, NEW)
    assert path.read_bytes() == NEW
    assert os.listdir(path.parent) == ["1.json"]


def test_a_write_the_system_itself_refuses(path):
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4, hard))
    try:
        with pytest.raises(SaveError, match="could not be saved: File too large"):
            write_atomic(path, NEW)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert path.read_bytes() == OLD
    assert os.listdir(path.parent) == ["1.json"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names on this system")
def test_a_pipe_in_the_way_is_neither_waited_for_nor_replaced(tmp_path):
    pipe = tmp_path / "1.json"
    os.mkfifo(pipe)
    with pytest.raises(SaveError, match="a folder, a pipe or a device is in its place"):
        write_atomic(pipe, NEW)
    assert pipe.is_fifo()
    assert os.listdir(tmp_path) == ["1.json"]


# ------------------------------------------------------------------------- links out of a dataset


@pytest.fixture
def dataset(tmp_path) -> Path:
    (tmp_path / "dataset" / "inner").mkdir(parents=True)
    (tmp_path / "outside").mkdir()
    (tmp_path / "outside" / "secret").write_bytes(OLD)
    return tmp_path / "dataset"


@pytest.mark.parametrize(
    ("link", "to", "written"),
    [
        ("1.json", "../outside/secret", "1.json"),
        ("1.json", "../outside/new", "1.json"),
        ("linked", "../outside", "linked/secret"),
        ("1.json", "../dataset-of-another-name", "1.json"),
    ],
    ids=["to a file", "to nothing yet", "a folder", "a sibling that starts alike"],
)
def test_links_that_lead_out_of_the_dataset_are_not_followed(dataset, link, to, written):
    (dataset / link).symlink_to(to)
    with pytest.raises(SaveError, match="is a link that leads out of the dataset; not followed"):
        write_atomic(dataset / written, NEW, inside=dataset)
    assert (dataset / link).is_symlink()
    assert sorted(os.listdir(dataset.parent)) == ["dataset", "outside"]
    assert os.listdir(dataset.parent / "outside") == ["secret"]
    assert (dataset.parent / "outside" / "secret").read_bytes() == OLD


def test_links_within_the_dataset_and_to_the_dataset_are_followed(dataset):
    (dataset / "inner" / "real.json").write_bytes(OLD)
    (dataset / "1.json").symlink_to("inner/real.json")
    (dataset.parent / "linked").symlink_to("dataset")
    write_atomic(dataset.parent / "linked" / "1.json", NEW, inside=dataset)
    assert (dataset / "inner" / "real.json").read_bytes() == NEW
    assert (dataset / "1.json").is_symlink()
    write_atomic(dataset / "1.json", OLD, inside=dataset.parent / "linked")
    assert (dataset / "inner" / "real.json").read_bytes() == OLD
    write_atomic(dataset / "2.json", NEW, inside=dataset)
    assert (dataset / "2.json").read_bytes() == NEW


def test_a_link_in_a_circle_is_an_error(dataset):
    (dataset / "1.json").symlink_to("2.json")
    (dataset / "2.json").symlink_to("1.json")
    with pytest.raises(SaveError, match="could not be saved"):
        write_atomic(dataset / "1.json", NEW, inside=dataset)
    assert (dataset / "1.json").is_symlink()


def test_without_a_folder_to_stay_in_links_are_followed_anywhere(dataset):
    (dataset / "1.json").symlink_to("../outside/secret")
    write_atomic(dataset / "1.json", NEW)
    assert (dataset.parent / "outside" / "secret").read_bytes() == NEW
