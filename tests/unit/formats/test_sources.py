"""Folders, archives and which file belongs to which frame."""

import unicodedata
import warnings
import zipfile
from pathlib import Path

import pytest

from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.csv_tables import read_frame_table, read_table
from procc_annotator.formats.file_listing import list_annotations, list_cameras
from procc_annotator.formats.file_source import open_source
from procc_annotator.formats.frame_names import ByFrame, FrameTable


def make(folder: Path, *names: str) -> Path:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(name)
    return folder


def zipped(folder: Path, target: Path) -> Path:
    with zipfile.ZipFile(target, "w") as archive:
        for path in sorted(folder.rglob("*")):
            archive.write(path, path.relative_to(folder))
    return target


NAMES = ("10.json", "9.json", "camera_9.json", ".hidden.json", "notes.txt", "jac.json")


@pytest.mark.parametrize("inside", ["", "test/"])
@pytest.mark.parametrize("as_zip", [False, True])
def test_folders_and_archives_with_or_without_a_split_look_the_same(tmp_path, inside, as_zip):
    folder = make(tmp_path / "data", *(inside + n for n in (*NAMES, "__MACOSX/._9.json")))
    source = open_source(zipped(folder, tmp_path / "data.zip") if as_zip else folder)
    with source:
        found = list_annotations(source)
        assert found == {"9": f"{inside}9.json", "10": f"{inside}10.json"}
        assert list(found) == ["9", "10"]
        assert list_cameras(source) == {"9": f"{inside}camera_9.json"} | {
            "notes": f"{inside}notes.txt"
        }
        assert source.read(found["9"]) == f"{inside}9.json".encode()


def test_homographies_by_name(tmp_path):
    folder = make(tmp_path, "1.npy", "00002_homography.npy", "3.homographyMatrix")
    assert list_cameras(open_source(folder)) == {
        "1": "1.npy",
        "00002": "00002_homography.npy",
        "3": "3.homographyMatrix",
    }
    assert set(list_cameras(open_source(folder), "wc14")) == {"1", "00002", "3"}
    assert list_cameras(open_source(folder), "soccernet") == {}


def test_two_cameras_for_one_frame_are_an_error(tmp_path):
    folder = make(tmp_path, "1.npy", "1_homography.npy")
    with pytest.raises(InputError, match="second file for frame '1'"):
        list_cameras(open_source(folder))


def test_a_json_camera_beats_a_homography_and_says_so(tmp_path):
    folder = make(tmp_path, "camera_2.json", "1.npy", "2.npy", "10.npy")
    found = list_cameras(open_source(folder))
    assert list(found.items()) == [("1", "1.npy"), ("2", "camera_2.json"), ("10", "10.npy")]
    assert [n.split(";")[0] for n in found.notices] == [
        "1 frame has a JSON camera and a homography"
    ]
    chosen = list_cameras(open_source(folder), "carwc")
    assert list(chosen.items()) == [("1", "1.npy"), ("2", "2.npy"), ("10", "10.npy")]
    assert not chosen.notices


def test_plain_json_beside_named_cameras_is_passed_over_with_a_word(tmp_path):
    found = list_cameras(open_source(make(tmp_path, "camera_1.json", "1.json", "2.json")))
    assert found == {"1": "camera_1.json"}
    (notice,) = found.notices
    assert notice.startswith("1 file like 2.json taken for an annotation, not a camera")


def test_annotations_beside_homographies_are_not_cameras(tmp_path):
    folder = make(tmp_path, "1.json", "2.json", "1.homographyMatrix", "2.jpg", "README.txt")
    found = list_cameras(open_source(folder))
    assert found == {"1": "1.homographyMatrix", "README": "README.txt"}
    assert not found.notices
    assert set(list_annotations(open_source(folder))) == {"1", "2"}


def test_plain_names_are_cameras_in_a_folder_of_their_own(tmp_path):
    folder = make(tmp_path, "1.json", "2.json", "README.txt")
    assert list(list_cameras(open_source(folder))) == ["1", "2", "README"]


def test_a_split_folder_may_have_a_dot_and_a_member_may_be_replaced(tmp_path):
    folder = make(tmp_path / "data", "v1.2/1.json")
    assert list_annotations(open_source(folder)) == {"1": "v1.2/1.json"}
    path = tmp_path / "z.zip"
    with zipfile.ZipFile(path, "w") as archive, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        archive.writestr("1.json", "old")
        archive.writestr("1.json", "new")
    with open_source(path) as source:
        assert source.read(list_annotations(source)["1"]) == b"new"


@pytest.mark.parametrize("inside", ["", "test/"])
def test_names_in_an_archive_may_begin_at_its_top(tmp_path, inside):
    """As ``zip`` and ``tar`` of other programs store ``.``: with ``./`` before every name."""
    path = tmp_path / "z.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("./", "")
        for name in ("2", "10"):
            archive.writestr(f"./{inside}{name}.json", name)
    with open_source(path) as source:
        found = list_annotations(source)
        assert list(found) == ["2", "10"]
        assert found.only_folder == inside
        assert [source.read(file) for file in found.values()] == [b"2", b"10"]
        assert source.tree() == list(found.values())
        assert source.folders() == ([inside.rstrip("/")] if inside else [])


def test_an_archive_with_a_name_that_climbs_out_is_refused(tmp_path):
    (tmp_path / "secret.json").write_text("secret")
    (tmp_path / "in").mkdir()
    path = tmp_path / "in" / "z.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("../secret.json", "mine")
        archive.writestr("1.json", "{}")
    with pytest.raises(
        InputError, match=r"z\.zip: holds the name '\.\./secret\.json', which leads"
    ):
        open_source(path)
    assert (tmp_path / "secret.json").read_text() == "secret"


def test_a_single_file_is_a_set_of_one(tmp_path):
    make(tmp_path, "camera_7.json", "camera_8.json")
    source = open_source(tmp_path / "camera_7.json")
    assert list_cameras(source) == {"7": "camera_7.json"}
    assert source.read("camera_7.json") == b"camera_7.json"


def test_what_cannot_be_opened_is_said(tmp_path):
    with pytest.raises(UsageError, match="no such file or folder"):
        open_source(tmp_path / "absent")
    (tmp_path / "bad.zip").write_bytes(b"PK nonsense")
    with pytest.raises(InputError, match="not a readable zip archive"):
        open_source(tmp_path / "bad.zip")


def test_a_folder_in_place_of_a_file_and_a_damaged_member(tmp_path):
    folder = make(tmp_path / "data", "1.json", "3.json")
    (folder / "2.json").mkdir()
    source = open_source(folder)
    assert list(list_annotations(source)) == ["1", "2", "3"]
    with pytest.raises(InputError, match=r"2\.json: cannot be read: is a folder, expected a file"):
        source.read("2.json")
    with pytest.raises(InputError, match="cannot be read"):
        source.read("4.json")
    path = zipped(make(tmp_path / "other", "1.json"), tmp_path / "z.zip")
    data = bytearray(path.read_bytes())
    start = data.index(b"1.json") + len(b"1.json")
    data[start] ^= 0xFF
    path.write_bytes(bytes(data))
    with open_source(path) as archive, pytest.raises(InputError, match="cannot be read"):
        archive.read("1.json")


def test_a_link_in_a_circle_is_one_file_that_cannot_be_read(tmp_path):
    (tmp_path / "good.json").write_text("{}")
    (tmp_path / "loop.json").symlink_to("loop.json")
    with open_source(tmp_path) as folder:
        assert list(list_annotations(folder)) == ["good", "loop"]
        with pytest.raises(InputError, match=r"loop\.json: cannot be read"):
            folder.read("loop.json")


def test_a_packed_tree_is_called_by_what_lies_in_its_own_folder(tmp_path):
    """As who packs a folder of matches gets it; beside what a Mac adds."""
    for stem, frames in (("anna", ["g1/1", "g2/1"]), ("ben", ["anna/g1/1", "anna/g2/1"])):
        path = tmp_path / f"{stem}.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("anna/", "")
            archive.writestr("__MACOSX/anna/g1/._1.json", "x")
            for game in ("g1", "g2"):
                archive.writestr(f"anna/{game}/1.json", game)
        with open_source(path) as source:
            found = list_annotations(source)
            assert list(found) == frames
            assert [source.read(file) for file in found.values()] == [b"g1", b"g2"]
    with zipfile.ZipFile(tmp_path / "test.zip", "w") as archive:
        archive.writestr("test/1.json", "{}")
    with open_source(tmp_path / "test.zip") as source:
        assert list_annotations(source).only_folder == "test/"


# Frames are found whatever their folders are called and however their letters are composed.

COMPOSED = unicodedata.normalize("NFC", "café")
APART = unicodedata.normalize("NFD", "café")


@pytest.mark.parametrize("here", [COMPOSED, APART])
@pytest.mark.parametrize("asked", [COMPOSED, APART])
def test_letters_and_folders_may_differ_at_once(here, asked):
    table = FrameTable({f"{here}/1": "a"})
    assert [table.get(f"{asked}/{inner}1") for inner in ("", "img1/", "images/")] == ["a"] * 3
    assert f"{asked}/2" not in table
    within = FrameTable({f"{here}/img1/1": "a"})
    assert within[f"{asked}/1"] == "a"
    flat = ByFrame({f"{here}_1": "a"})
    flat.only_folder = f"{here}/"
    assert flat[f"{asked}/{asked}_1"] == "a"
    assert f"other/{asked}_1" not in flat


def test_a_frame_is_called_in_other_lists_with_the_folder_it_lies_in():
    tree = ByFrame({"g1/1": "a", "g2/1": "b"})
    one = ByFrame({"1": "c"})
    one.only_folder = "g2/"
    assert one.called_in(tree, "1") == "g2/1"
    assert [tree.called_in(one, name) for name in tree] == [None, "1"]


# What every table about frames is read by, and what is wrong with one that cannot be used.


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "is empty"),
        ("name,light\n1,day\n", "line 1: has no column 'frame'"),
        ("frame,light\n1,day\n2\n", "line 3: has 1 cell, expected 2"),
        ("frame,light\n1,day\n\n1,night\n", "line 4: frame '1' again, after line 2"),
        ("frame,light\n,day\n", "line 2: names no frame"),
        ('frame,light\n1,"day\n', r"line \d: is no CSV"),
        (b"frame,light\n1,\xff\n", "is not UTF-8"),
    ],
)
def test_damaged_tables_are_one_clear_error(tmp_path, text, says):
    path = tmp_path / "table.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(InputError, match=says) as caught:
        read_frame_table(path, ["light"], "how it should look")
    assert str(path) in str(caught.value)


def test_rows_come_with_their_lines_whatever_separates_the_cells(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text("\ufeffframe; light ;\n\n'=1;day;x\n", encoding="utf-8")
    names, rows = read_frame_table(path, ["light"], "")
    assert names == ["frame", "light", ""]
    assert rows == [(3, {"frame": "=1", "light": "day", "": "x"})]
    assert read_table(path, ["light"], "") == (names, rows)


def test_a_frame_may_stand_once_in_each_set(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text("set,frame\na,1\nb,1\n")
    assert len(read_frame_table(path, (), "", in_sets=True)[1]) == 2
    with pytest.raises(InputError, match="again, after line 2"):
        read_frame_table(path, (), "")
