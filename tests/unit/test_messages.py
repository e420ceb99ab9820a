"""Remarks that say the same of many."""

from __future__ import annotations

from procc_annotator.messages import condensed


def test_of_many_remarks_that_differ_in_numbers_the_most_frequent_are_told() -> None:
    sizes = {f"scaled from 960x{700 + i} to 960x540": 1 for i in range(40)}
    sizes["scaled from 960x400 to 960x540"] = 7
    told = condensed({"no size is told": 2} | sizes)
    assert list(told)[:2] == ["no size is told", "scaled from 960x400 to 960x540"]
    assert len(told) == 5
    assert told["and 38 more like 'scaled from 960x701 to 960x540'"] == 38
    assert sum(told.values()) == 49


def test_a_few_remarks_are_told_as_they_are() -> None:
    remarks = {f"scaled from 960x{700 + i} to 960x540": i for i in range(5)} | {"another": 3}
    assert condensed(remarks) == remarks
