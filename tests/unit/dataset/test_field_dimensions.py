"""What a workspace keeps of its field: read again, forgiven when damaged, left when of another."""

from __future__ import annotations

import json

import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.joint_calibration import estimate_dimensions
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import (
    DIMENSIONS_SETTING,
    field_settings,
    store_dimensions,
)
from procc_annotator.errors import FieldError, InputError, UsageError
from procc_annotator.field.load import load_field, with_dimensions


def test_dimensions_are_there_when_the_dataset_is_opened_again(tmp_path) -> None:
    field = load_field("soccer")
    first = WorkspaceDatabase.open(tmp_path, "one")
    store_dimensions(first, with_dimensions(field, {"length": 101.3}))
    assert first.close()
    again = WorkspaceDatabase.open(tmp_path, "two")
    assert field_settings(again.settings(), field).dimensions == {"length": 101.3}
    store_dimensions(again, field)
    assert again.setting(DIMENSIONS_SETTING) is None
    assert not field_settings(again.settings(), field).dimensions
    again.close()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "cannot be read"),
        (json.dumps({"field": "soccer", "dimensions": {"length": "long"}}), "cannot be read"),
        (json.dumps({"field": "soccer", "dimensions": {"length": 30}}), "outside the range"),
        (json.dumps({"field": "soccer", "dimensions": {"lenght": 100}}), "no dimension"),
        (json.dumps({"field": "hockey", "dimensions": {"length": 60}}), ""),
    ],
)
def test_what_cannot_be_used_is_told_and_left(text, said) -> None:
    kept = field_settings({DIMENSIONS_SETTING: text}, load_field("soccer"))
    assert not kept.dimensions
    assert [said in problem for problem in kept.problems] == ([True] if said else [])


def test_a_field_says_what_is_not_nominal() -> None:
    field = load_field("soccer")
    assert (field.described, field.is_nominal) == ("soccer", True)
    sized = with_dimensions(field, {"length": 101.3, "width": 66.2})
    assert sized.described == "soccer 101.3 x 66.2 m"
    assert with_dimensions(field, {"width": 66.25}).described == "soccer 105 x 66.25 m"
    assert with_dimensions(sized, {}) == field
    with pytest.raises(FieldError, match="outside the range of the rules"):
        with_dimensions(field, {"length": 200.0})


def test_frames_that_cannot_be_read_take_no_part() -> None:
    def unreadable() -> FrameAnnotation:
        raise InputError("1.json", "is damaged")

    seen: list[tuple[int, int]] = []
    with pytest.raises(UsageError, match="no frame has a camera"):
        estimate_dimensions(
            {"1": unreadable, "2": FrameAnnotation},
            load_field("soccer"),
            size=(960, 540),
            progress=lambda done, total: seen.append((done, total)),
        )
    assert seen
