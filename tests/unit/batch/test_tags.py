"""Tags of frames from a CSV file, damaged ones too."""

from __future__ import annotations

import unicodedata
from pathlib import Path

import pytest

from procc_annotator.batch.grouping import FrameOrder, Tags, check_by
from procc_annotator.dataset.dataset_field import field_with_stadiums
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import field_for_frame, load_field

BOM = "\ufeff"
COMPOSED, APART = (unicodedata.normalize(form, "café") for form in ("NFC", "NFD"))
# As a table may call a frame, and as commands and the window may.
CALLED_OTHERWISE = [(COMPOSED, APART), ("g/1", "g/img1/1"), (f"{APART}/img1/1", f"{COMPOSED}/1")]


def tags(tmp_path: Path, text: str | bytes) -> Tags:
    path = tmp_path / "tags.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return Tags.read(path)


@pytest.mark.parametrize(
    "text",
    [
        "frame,stadium,light\n1,A,day\n10,,night\n",
        BOM + "frame,stadium,light\r\n1,A,day\r\n\r\n10,,night\r\n",
        "stadium; frame ;light\nA;1;day\n;10;night",
        "light\tframe\tstadium\nday\t1\tA\nnight\t10\t\n",
        'frame,stadium,light\n"1","A","day"\n10,"",night\n',
    ],
    ids=["plain", "bom-crlf", "semicolons", "tabs", "quoted"],
)
def test_forms_of_csv(tmp_path, text) -> None:
    read = tags(tmp_path, text)
    assert set(read.columns) == {"stadium", "light"}
    grouping = read.grouping(("light", "model", "stadium"), "any")
    assert grouping.of("1") == ("day", None, "A")
    assert grouping.of("10") == ("night", None, None)
    assert grouping.of("2") == (None, None, None)


def test_rows_of_a_named_set_count_for_it_only(tmp_path) -> None:
    read = tags(tmp_path, "set,frame,light\na,1,day\nb,1,night\n")
    assert read.columns == ("light",)
    assert [read.grouping(("light",), name).of("1") for name in "abc"] == [
        ("day",), ("night",), (None,),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("frame\n1\n", r"line 1: has no column of tags"),
        ("frame,\n1,day\n", r"line 1: column 2 has no name"),
    ],
)
def test_damaged_files_are_one_clear_error(tmp_path, text, says) -> None:
    with pytest.raises(InputError, match=says) as caught:
        tags(tmp_path, text)
    assert str(tmp_path / "tags.csv") in str(caught.value)


def test_what_can_be_grouped_by(tmp_path) -> None:
    read = tags(tmp_path, "frame,stadium,light\n1,A,day\n")
    assert check_by(["light", "model", "light"], read) == ("light", "model")
    with pytest.raises(UsageError, match="'lihgt': there is model, stadium, light"):
        check_by(["lihgt"], read)
    with pytest.raises(UsageError, match=r"--tags FILE"):
        check_by(["light"], None)
    taken = tags(tmp_path, "frame,model\n1,A\n")
    with pytest.raises(UsageError, match="rename"):
        check_by(["model"], taken)


@pytest.mark.parametrize(("told", "asked"), CALLED_OTHERWISE)
def test_tables_know_a_frame_by_its_other_names(tmp_path, told, asked) -> None:
    grouping = tags(tmp_path, f"frame,light\n{told},day\n").grouping(("light",), "any")
    assert grouping.of(asked) == ("day",)
    (tmp_path / "stadiums.csv").write_text(f"frame,stadium,length\n{told},Source,100\n")
    field = field_with_stadiums(load_field("soccer"), tmp_path)
    assert field_for_frame(field, asked).dimension("length").value == 100.0
    (tmp_path / "frames.csv").write_text(f"frame,shot,number\n{told},a,7\nnext,a,8\n")
    order = FrameOrder.read(tmp_path / "frames.csv")
    (shot,) = order.shots_of(["next", asked])
    assert (shot.frames, shot.numbers) == ((asked, "next"), (7, 8))
    (both,) = order.shots_of([asked, told, "next"])  # cameras and pictures of the same frames
    assert both.frames == (told, "next")
