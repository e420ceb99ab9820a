"""Archives, pipes, devices and huge files are refused before they cost time or memory."""

import os
import socket
import struct
import tracemalloc
import zipfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.database.location import read_settings
from procc_annotator.dataset.records import Status
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import (
    AnnotationError,
    CameraError,
    FieldError,
    ImageError,
    InputError,
    ProccError,
)
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import LARGEST_FILE, open_source, read_file
from procc_annotator.image.decoding import decode_bgra
from tests.fuzz.readers import FIELD, in_one_line

# ------------------------------------------------------------------------------------- archives


def archive(path: Path, *names: str) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("1.json", "{}")
        for name in names:
            info = zipfile.ZipInfo("x")
            info.filename = name  # the constructor would tidy the name up
            made.writestr(info, "{}")
    return path


@pytest.mark.parametrize(
    "name",
    [
        "../2.json",
        "a/../../2.json",
        "..",
        "/etc/2.json",
        "//server/share/2.json",
        "C:/2.json",
        "c:2.json",
        "a\\2.json",
        "..\\2.json",
        "\\\\server\\share\\2.json",
        "2.json\0.txt",
        "\x1b[2J/../2.json",
    ],
)
def test_an_archive_with_a_name_that_leads_out_is_refused_as_a_whole(tmp_path, name):
    path = archive(tmp_path / "z.zip", name)
    with pytest.raises(InputError) as caught:
        open_source(path)
    text = in_one_line(caught, str(path))
    assert "2.json" in text or name == ".."
    assert "which leads out of the archive" in text
    assert os.listdir(tmp_path) == ["z.zip"]


@pytest.mark.parametrize("name", ["..2.json", "a..b/2.json", "...", "test/2.json", "é:2.json"])
def test_names_that_only_look_like_it_are_fine(tmp_path, name):
    with open_source(archive(tmp_path / "z.zip", name)) as source:
        assert source.read("1.json") == b"{}"


def test_a_zip_bomb_is_refused_before_it_is_unpacked(tmp_path):
    path = tmp_path / "z.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as made:
        made.writestr("1.json", bytes(LARGEST_FILE + 1))
    assert path.stat().st_size < 100_000
    with open_source(path) as source:
        tracemalloc.start()
        with pytest.raises(InputError) as caught:
            source.read("1.json")
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    assert "holds 52 MB, expected an annotation or a camera" in in_one_line(
        caught, f"{path}/1.json"
    )
    assert peak < 1_000_000


def test_a_zip_bomb_that_lies_about_its_size_gives_no_more_than_it_announced(tmp_path):
    path = tmp_path / "z.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as made:
        made.writestr("1.json", bytes(30_000_000))
    data = path.read_bytes()
    path.write_bytes(data.replace(struct.pack("<L", 30_000_000), struct.pack("<L", 10)))
    with open_source(path) as source:
        tracemalloc.start()
        with pytest.raises(InputError, match="cannot be read: Bad CRC"):
            source.read("1.json")
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    assert peak < 1_000_000


def test_other_ways_of_packing_are_refused(tmp_path):
    path = tmp_path / "z.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_BZIP2) as made:
        made.writestr("1.json", "{}")
    with open_source(path) as source, pytest.raises(InputError, match="by an unusual method"):
        source.read("1.json")


def test_a_member_that_is_a_link_is_only_its_text(tmp_path):
    path = tmp_path / "z.zip"
    with zipfile.ZipFile(path, "w") as made:
        info = zipfile.ZipInfo("1.json")
        info.external_attr = 0o120777 << 16
        made.writestr(info, "../../secret.json")
    with open_source(path) as source:
        assert source.read("1.json") == b"../../secret.json"


# ------------------------------------------------------------------------- special and huge files


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names on this system")
def test_pipes_are_refused_and_not_waited_for(tmp_path):
    for name in ("1.json", "z.zip", "f.toml"):
        os.mkfifo(tmp_path / name)
    source = open_source(tmp_path)
    assert list(list_annotations(source)) == ["1"]
    with pytest.raises(InputError, match="is a pipe, a socket or a device, expected a file"):
        source.read("1.json")
    for name in ("1.json", "z.zip"):
        with pytest.raises(InputError, match="is a pipe, a socket or a device, expected a file"):
            open_source(tmp_path / name)
    with pytest.raises(FieldError, match="is a pipe, a socket or a device"):
        load_field(tmp_path / "f.toml")


def _socket(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(str(path))


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names on this system")
@pytest.mark.parametrize("make", [os.mkfifo, _socket])
@pytest.mark.parametrize(
    "name", ["1.jpg", "1.mp4", "1.json", "workspace.db", "workspace.db.backup"]
)
def test_a_dataset_with_a_pipe_or_socket_in_it_opens_and_closes(tmp_path, monkeypatch, make, name):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "own"))
    monkeypatch.chdir(tmp_path)  # a socket's path is short
    (tmp_path / ".procc").mkdir()
    make(Path(".procc", name) if "workspace" in name else Path(name))
    database = WorkspaceDatabase.open(tmp_path, "Anna")
    database.set_status("1", Status.DONE)
    assert database.close()
    assert any("a pipe, a socket" in line for line in database.notices) == ("workspace" in name)
    with suppress(InputError):
        read_settings(tmp_path)
    for frame in Workspace.open(tmp_path, FIELD).frames:
        with pytest.raises(ImageError, match="a pipe, a socket"):
            decode_bgra(frame.image_path)


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no devices with names on this system")
def test_devices_are_refused_also_through_links(tmp_path):
    (tmp_path / "1.json").symlink_to("/dev/zero")
    (tmp_path / "f.toml").symlink_to("/dev/zero")
    with pytest.raises(InputError, match="is a pipe, a socket or a device, expected a file"):
        open_source(tmp_path).read("1.json")
    with pytest.raises(FieldError, match="is a pipe, a socket or a device"):
        load_field(tmp_path / "f.toml")


def test_files_far_too_large_are_refused_before_reading(tmp_path):
    for name in ("1.json", "f.toml"):
        with open(tmp_path / name, "wb") as file:
            file.truncate(10**12)  # a terabyte that takes no room
    reads: list[Callable[[], bytes]] = [
        lambda: open_source(tmp_path).read("1.json"),
        lambda: read_file(tmp_path / "1.json"),
    ]
    for read in reads:
        with pytest.raises(InputError) as caught:
            read()
        assert "holds 1000000 MB, expected" in in_one_line(caught, str(tmp_path / "1.json"))
    with pytest.raises(FieldError, match="is larger than 256 kB"):
        load_field(tmp_path / "f.toml")
    with pytest.raises(CameraError, match=r"larger than 64 kB, expected 9 numbers"):
        read_camera_file(b"1 0 0 0 1 0 0 0 1" + b" " * 65536, path="1.txt")


def test_a_file_is_read_or_refused_as_the_caller_calls_it(tmp_path):
    (tmp_path / "1.json").write_bytes(b"{}")
    assert read_file(tmp_path / "1.json") == b"{}"
    with pytest.raises(AnnotationError, match="cannot be read: No such file") as caught:
        read_file(tmp_path / "2.json", AnnotationError)
    assert isinstance(caught.value.__cause__, FileNotFoundError)
    with pytest.raises(AnnotationError, match="is a folder, expected a file"):
        read_file(tmp_path, AnnotationError)


def test_a_path_that_cannot_be_looked_at_is_said(tmp_path, monkeypatch):
    def forbid(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    with monkeypatch.context() as patch:
        patch.setattr(os, "stat", forbid)
        with pytest.raises(InputError, match="1: cannot be read: Permission denied"):
            open_source(Path("1"))
    for name in ("n" * 5000, "nul\0", "1.json/under-a-file"):
        (tmp_path / "1.json").touch()
        with pytest.raises(ProccError):
            open_source(tmp_path / name)
