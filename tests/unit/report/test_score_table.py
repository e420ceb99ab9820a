"""The table of scores that grows: keys, kinds of files, damage, several writers at once."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.batch.scoring import FrameResult
from procc_annotator.errors import InputError, ProccError, SaveError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.atomic import exclusive_lock
from procc_annotator.metrics.sets import AnnotatedExtent
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.scores.score_files import KEYS, NAMES, ScoreRow
from procc_annotator.report.scores.score_table import (
    append_rows,
    check_table,
    figures_of,
    read_csv_rows,
    read_parquet_rows,
    table_csv,
    whole_rows,
)

SETUP = EvaluationSetup(load_field("soccer"))


def row(
    frame: str = "1", threshold: float = 5.0, jac: float | None = 0.1, **changes: Any
) -> ScoreRow:
    values = {
        "set": "wc14", "method": "pnl", "frame": frame, "threshold": threshold,
        "field": "soccer", "protocol": "soccernet", "width": 960, "height": 540,
        "off_plane": "missed", "mirrored_labels": True, "counted": True, "model": "pinhole",
        "jac": jac, "tp": 1, "fp": 2, "fn": 3, "mirrored": False, "precision": 1 / 3,
        "recall": None, "mean_reprojection_error": 2.5e-17, "mean_error": 1.5, "points": 11,
        "camera": 'a, "b"\nc.json', "error": None, "version": "0.1.0",
        "fitted_on_these_clicks": False, "fitted_on_another_version": False,
        "annotated_elements": 7, "spread": 0.25,
    } | changes  # fmt: skip
    assert list(values) == list(NAMES)
    return tuple(values.values())


def read(path: Path) -> list[ScoreRow]:
    return (read_csv_rows if path.suffix == ".csv" else read_parquet_rows)(path)


@pytest.fixture(params=[".csv", ".parquet"])
def path(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    if request.param == ".parquet":
        pytest.importorskip("pyarrow")
    return tmp_path / f"board{request.param}"


def test_rows_come_back_as_they_were(path: Path) -> None:
    rows = [row(), row("2", jac=None, model=None, tp=None, mirrored=None, error="no camera, é")]
    append_rows(path, rows)
    assert read(path) == rows
    assert [type(value) for value in read(path)[0]] == [type(value) for value in rows[0]]
    assert [p.name for p in path.parent.iterdir()] == [path.name]


def test_the_same_key_replaces_and_all_else_stays(path: Path) -> None:
    others = [row("2"), row(threshold=2.0), row(set="ts"), row(method="nbjw"), row(width=1280),
              row(protocol="procc"), row(off_plane="left_out"), row(mirrored_labels=False),
              row(field="basketball"), row(height=720)]  # fmt: skip
    append_rows(path, [*others[:3], row(jac=0.1), *others[3:]])
    append_rows(path, [row("9"), row(jac=0.9, camera="new")])
    expected = [*others[:3], row(jac=0.9, camera="new"), *others[3:], row("9")]
    assert read(path) == expected
    before = path.read_bytes()
    append_rows(path, expected)
    assert path.read_bytes() == before


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("name,jac\n1,2\n", "line 1: is no table of scores"),
        ("", "line 1: is no table of scores"),
        ("{HEAD}\n{ROW},more\n", "line 2: has 30 cells, expected 29"),
        ("{HEAD}\n{ROW}\na,b\n", "line 3: has 2 cells"),
        ("{HEAD}\n{ROW}\n".replace("{ROW}", "{960}"), "line 2: width is 'wide', expected a whole"),
        ("{HEAD}\n{jac}\n", "line 2: jac is 'nan', expected a number"),
        ("{HEAD}\n{key}\n", "line 2: frame is '', expected some text"),
        ("{HEAD}\n{true}\n", "line 2: mirrored_labels is 'yes', expected true or false"),
        ('{HEAD}\n"open', "is no CSV"),
        ("\udcff", "not UTF-8"),
    ],
)
def test_a_damaged_csv_is_one_clear_error_and_untouched(
    tmp_path: Path, text: str, says: str
) -> None:
    head, good = table_csv([row(camera="c.json")]).decode().splitlines()
    for mark, line in {
        "{HEAD}": head, "{ROW}": good, "{960}": good.replace("960", "wide"),
        "{jac}": good.replace("0.1,1,2", "nan,1,2"), "{key}": good.replace("pnl,1,", "pnl,,"),
        "{true}": good.replace("missed,true", "missed,yes"),
    }.items():  # fmt: skip
        text = text.replace(mark, line)
    path = tmp_path / "board.csv"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    before = path.read_bytes()
    for attempt in (lambda: check_table(path), lambda: append_rows(path, [row()])):
        with pytest.raises(InputError, match=says) as caught:
            attempt()
        assert str(path) in str(caught.value)
    assert path.read_bytes() == before


def test_a_damaged_parquet_is_one_clear_error_and_untouched(tmp_path: Path) -> None:
    arrow = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "board.parquet"
    append_rows(path, [row()])
    whole = path.read_bytes()
    parquet.write_table(arrow.table({"a": [1]}), tmp_path / "other.parquet")
    other = (tmp_path / "other.parquet").read_bytes()
    for damaged, says in (
        (whole[:-9], "no readable Parquet"), (b"", "no readable Parquet"), (b"x" * 99, "no read"),
        (other, "another version: expected the columns set, method"),
    ):  # fmt: skip
        path.write_bytes(damaged)
        with pytest.raises(InputError, match=says):
            check_table(path)
        with pytest.raises(InputError, match=says):
            append_rows(path, [row()])
        assert path.read_bytes() == damaged


def test_what_cannot_be_a_table_is_said_before_the_work(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"\.csv or \.parquet"):
        check_table(tmp_path / "board.xlsx")
    folder = tmp_path / "board.csv"
    folder.mkdir()
    with pytest.raises(InputError, match="cannot be read"):
        check_table(folder)


def test_without_pyarrow_the_extra_is_advised(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(ProccError, match=r"pip install 'procc-annotator\[parquet\]'"):
        check_table(tmp_path / "board.parquet")


def test_processes_lose_none_of_each_others_rows(path: Path) -> None:
    program = (
        "import sys; from pathlib import Path\n"
        "from procc_annotator.report.scores.score_table import append_rows\n"
        f"good = {row()!r}\n"
        "for i in range(10):\n"
        "    append_rows(Path(sys.argv[1]), [(good[0], sys.argv[2], str(i), *good[3:])])\n"
    )
    writers = [subprocess.Popen([sys.executable, "-c", program, path, m]) for m in "ab"]
    assert [writer.wait(60) for writer in writers] == [0, 0]
    keys = {r[:KEYS] for r in read(path)}
    assert keys == {row(str(i), method=m)[:KEYS] for m in "ab" for i in range(10)}
    assert [p.name for p in path.parent.iterdir()] == [path.name]


def test_waiting_for_another_writer_has_an_end(tmp_path: Path) -> None:
    path = tmp_path / "board.csv"
    with (
        exclusive_lock(path),
        pytest.raises(SaveError, match="another process has been writing"),
        exclusive_lock(path, timeout_s=0.1),
    ):
        pass
    with exclusive_lock(path, timeout_s=0.1):
        pass
    with (
        pytest.raises(SaveError, match="choose another folder"),
        exclusive_lock(tmp_path / "no/x.csv"),
    ):
        pass


def test_a_frame_without_scores_has_empty_figures() -> None:
    unreadable = FrameResult("\udcff", None, "a.json: is damaged", (), {}, counted=False)
    (made,) = whole_rows("s", "m", SETUP, figures_of(unreadable, (5.0,)))
    entries = dict(zip(NAMES, made, strict=True))
    assert entries["frame"] == "\\udcff"
    assert entries["counted"] is False
    assert entries["error"] == "a.json: is damaged"
    assert [entries[k] for k in ("jac", "tp", "mirrored", "points", "model")] == [None] * 5
    assert [entries[k] for k in ("annotated_elements", "spread")] == [None, None]
    (made,) = whole_rows("s", "m", SETUP, figures_of(FrameResult("1", None, None, (), {}), (5.0,)))
    assert dict(zip(NAMES, made, strict=True))["error"] == "no camera"
    assert not any(isinstance(value, float) and math.isnan(value) for value in made)


def test_rows_say_how_much_is_annotated_and_tables_without_it_grow_on(tmp_path: Path) -> None:
    told = FrameResult("1", None, None, (), {}, clicked=AnnotatedExtent(7, 0.25))
    (made,) = whole_rows("s", "m", SETUP, figures_of(told, (5.0,)))
    assert made[-2:] == (7, 0.25)
    path = tmp_path / "board.csv"
    lines = table_csv([row(camera="c.json")]).decode().splitlines()
    path.write_text("".join(line.rsplit(",", 2)[0] + "\n" for line in lines), "utf-8")
    append_rows(path, [row("2")])
    assert read(path) == [row(camera="c.json", annotated_elements=None, spread=None), row("2")]
