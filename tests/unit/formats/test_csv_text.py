"""What every table about frames is read by, and what is wrong with one that cannot be used."""

from __future__ import annotations

import pytest

from procc_annotator.errors import InputError
from procc_annotator.formats.csv_tables import read_frame_table, read_table


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "is empty"),
        ("\n\n", "is empty"),
        ("name,light\n1,day\n", "line 1: has no column 'frame'"),
        ("frame,night\n1,day\n", "line 1: has no column 'light'"),
        ("frame,light,light\n1,a,b\n", "line 1: has two columns 'light'"),
        ("frame,light\n1,day\n2\n", "line 3: has 1 cell, expected 2"),
        ("frame,light\n1,day,x\n", "line 2: has 3 cells, expected 2"),
        ("frame,light\n1,day\n\n1,night\n", "line 4: frame '1' again, after line 2"),
        ("frame,light\n,day\n", "line 2: names no frame"),
        ('frame,light\n1,"day\n', r"line \d: is no CSV"),
        (b"frame,light\n1,\xff\n", "is not UTF-8"),
    ],
)
def test_damaged_tables_are_one_clear_error(tmp_path, text, says) -> None:
    path = tmp_path / "table.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(InputError, match=says) as caught:
        read_frame_table(path, ["light"], "how it should look")
    assert str(path) in str(caught.value)


def test_rows_come_with_their_lines_whatever_separates_the_cells(tmp_path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("\ufeffframe; light ;\n\n'=1;day;x\n", encoding="utf-8")
    names, rows = read_frame_table(path, ["light"], "")
    assert names == ["frame", "light", ""]
    assert rows == [(3, {"frame": "=1", "light": "day", "": "x"})]
    assert read_table(path, ["light"], "") == (names, rows)


def test_a_frame_may_stand_once_in_each_set(tmp_path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("set,frame\na,1\nb,1\n")
    assert len(read_frame_table(path, (), "", in_sets=True)[1]) == 2
    with pytest.raises(InputError, match="again, after line 2"):
        read_frame_table(path, (), "")
