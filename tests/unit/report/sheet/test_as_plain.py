"""A table in a file or a pipe is the one of the terminal without its colours."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from procc_annotator.report.sheet.as_plain import plain_table
from procc_annotator.report.sheet.as_terminal import terminal_table
from procc_annotator.report.sheet.sheet import Column, Sheet

NAMES = (Column("name", "Frame"), Column("jac", "JaC [%]", "number", written=".2f"))
ROWS = (("1", 0.5), ("00012", None), ("前半 3", 12.25), ("🙂", 1.0))
LONG = "what every figure rests on is told in more words than the table below it is wide"


def on_terminal(sheet: Sheet, width: int) -> str:
    file = io.StringIO()
    options = {"markup": False, "emoji": False, "highlight": False}
    Console(file=file, width=width, force_terminal=False, **options).print(terminal_table(sheet))
    return "\n".join(line.rstrip() for line in file.getvalue().split("\n"))


@pytest.mark.parametrize(
    "sheet",
    [
        Sheet("a", "Frames", NAMES, ROWS),
        Sheet("a", "Frames", NAMES, ()),
        Sheet("a", "Frames [of] :a: set", NAMES, ROWS, LONG, (LONG, "short", LONG.upper())),
        Sheet("a", "Frames", NAMES, ROWS, parts=(0, 2, 3), bold=frozenset({(0, 1)})),
        Sheet(
            "a", "Groups", (*NAMES, Column("b", "mean\nof all", group="ours")),
            tuple((*row, "two\nlines" if row[1] else "") for row in ROWS),
        ),
    ],
)  # fmt: skip
def test_it_has_the_same_characters(sheet: Sheet) -> None:
    plain = plain_table(sheet, 132)
    assert plain is not None
    assert plain == on_terminal(sheet, 132)


def test_what_does_not_fit_or_shows_nothing_is_left_to_the_library() -> None:
    assert plain_table(Sheet("a", "Frames", NAMES, ROWS), 19) is None
    for name in (" blank", "blank "):
        assert plain_table(Sheet("a", "Frames", NAMES, ((name, 1.0),)), 132) is None
