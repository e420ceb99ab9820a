"""The noise of clicks as ``agree`` measured it, read from the JSON it wrote."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from procc_annotator.errors import InputError
from procc_annotator.io.json_text import decode_as
from procc_annotator.io.source import read_file
from procc_annotator.metric.chance.clicks import noise_of_floor
from procc_annotator.session.runs.moved_clicks import ClickNoise

_ADVICE = "expected what `agree A B --output FILE.json` writes"


def noise_from(path: Path, seed: int) -> ClickNoise:
    """One annotator's standard deviation, from the median distance of every two.

    Raises:
        InputError: it cannot be read, or is no agreement, or none with any distance.
    """
    content = decode_as(read_file(path), object, "JSON", path=path)
    size, floor = _member(content, "size"), _member(content, "summary", "noise_floor")
    if not (isinstance(size, list) and len(size) == 2 and all(type(n) is int for n in size)):
        raise InputError(path, "has no size of pictures", place="size", advice=_ADVICE)
    if min(size) < 2 or not isinstance(floor, Mapping):
        raise InputError(path, "is no agreement", place="summary.noise_floor", advice=_ADVICE)
    median = floor.get("median")
    if not isinstance(median, int | float) or not math.isfinite(median) or median <= 0:
        raise InputError(
            path,
            f"has a median distance of {median}, expected one above 0 px",
            place="summary.noise_floor.median",
            advice="compare annotators who clicked the same elements each for themselves",
        )
    return ClickNoise(
        noise_of_floor(median), seed=seed, of_size=(size[0], size[1]), told_by=path.name
    )


def _member(content: Any, *keys: str) -> Any:
    for key in keys:
        content = content.get(key) if isinstance(content, Mapping) else None
    return content
