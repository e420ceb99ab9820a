"""Files with damaged bytes are refused in one clear line, or read as they are, by every reader."""

from collections.abc import Callable, Iterator, Sequence

import pytest

from procc_annotator.formats.cameras.registry import CAMERA_FORMATS
from tests.fuzz.readers import (
    ANNOTATIONS,
    ARCHIVES,
    ARRAYS,
    CAMERAS,
    COLLECTIONS,
    HOMOGRAPHIES,
    READERS,
    check_all_project,
    check_field,
    check_place,
    check_projects,
    read_camera,
    read_collection,
)

Damage = Callable[[str, Sequence[bytes], int], Iterator[bytes]]


@pytest.mark.laps
@pytest.mark.parametrize("name", READERS)
def test_damaged_bytes(judge, damage, tmp_path, request, name):
    reader, path = READERS[name], tmp_path / READERS[name].file_name
    real = request.getfixturevalue("shared_data") if name.startswith("real ") else tmp_path
    seeds = reader.seeds(real)
    for seed in () if name.endswith("detected") or reader.kind == "picture" else seeds[:3]:
        path.write_bytes(seed)
        assert reader.read(path), "an intact file is refused"
    for number, data in enumerate(damage(name, seeds, reader.count)):
        file = reader.mend(data) if reader.mend and number % 2 else data
        path.write_bytes(file)
        read = judge(reader.kind, str(path), lambda: reader.read(path))
        if read is not None:
            reader.check(read, file)
            if reader.kind == "field":
                check_field(read, file, path)
        elif name.endswith("annotation"):
            check_place(file)


@pytest.mark.laps
def test_damaged_tables_of_archives(judge, damage, tmp_path):
    """Most of an archive is content; here only its headers and its table are damaged."""
    reader, path = READERS["archive"], tmp_path / "z.zip"
    for seed in ARCHIVES[2:]:
        start = seed.index(b"PK\x01\x02")
        for tail in damage(f"table {len(seed)}", [seed[start:]], 25):
            path.write_bytes(seed[:start] + tail)
            members = judge("archive", str(path), lambda: reader.read(path))
            reader.check(members or [], b"")


def test_every_camera_format_takes_every_kind_of_file(judge, tmp_path):
    single = (ANNOTATIONS[0], CAMERAS[0], HOMOGRAPHIES[0], ARRAYS[0], b"", b"\0" * 99)
    path = tmp_path / "1.txt"
    for data in single:
        path.write_bytes(data)
        for fmt in CAMERA_FORMATS[1:]:
            loaded = judge("camera", str(path), lambda f=fmt: read_camera(f)(path))
            if loaded is not None:
                check_projects(loaded)
    path = tmp_path / "1.json"
    for data in (data for seeds in COLLECTIONS.values() for data in seeds):
        path.write_bytes(data)
        for fmt in COLLECTIONS:
            cameras = judge("camera", str(tmp_path), lambda f=fmt: read_collection(f)(path))
            check_all_project(cameras or [])
