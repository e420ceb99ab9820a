"""Tables of tracked cameras and of the units of a run."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from itertools import groupby

import numpy as np

from procc_annotator.batch.unit_store import DONE, MatchUnits, UnitStore
from procc_annotator.formats.cameras.packed import PackedCameras
from procc_annotator.messages import pluralize
from procc_annotator.report.tables.metrics import COVERAGE, RESIDUAL
from procc_annotator.report.tables.table import (
    Column,
    MetricTable,
    count_column,
    metric_column,
    shortened,
)

STATES = ("anchor", "followed", "bridged", "lost")
_SHOWN, _SHOWN_MATCHES = 20, 1000
_RECENT_S = 1800.0  # over which the speed is measured


def shots_table(cameras: PackedCameras) -> MetricTable:
    """A row a shot: its frames by state, and how well the paint agrees, median."""
    columns = (
        Column("from", "from"),
        Column("to", "to"),
        count_column("frames"),
        *map(count_column, STATES),
        metric_column(COVERAGE),
        metric_column(RESIDUAL),
    )
    rows = []
    for _, own in groupby(range(len(cameras)), key=cameras.shot.__getitem__):
        frames = list(own)
        states = Counter(cameras.state[i] for i in frames)
        known = [i for i in frames if cameras.has_camera[i]]
        medians = (_median(values[known]) for values in (cameras.coverage, cameras.residual_px))
        counts = (len(frames), *(states[state] for state in STATES))
        rows.append((cameras.frame[frames[0]], cameras.frame[frames[-1]], *counts, *medians))
    title = f"{pluralize(len(cameras), 'frame')} in {pluralize(len(rows), 'shot')}"
    return shortened(MetricTable("shots", title, columns, tuple(rows)), _SHOWN)


def _median(values: np.ndarray) -> float | None:
    known = values[np.isfinite(values)]
    return float(np.median(known)) if len(known) else None


def gaps_table(cameras: PackedCameras) -> MetricTable:
    """Stretches of frames that have no camera, or one propagated from others."""
    columns = (
        Column("from", "from"), Column("to", "to"), count_column("frames"), Column("state"),
        Column("why", "why"),
    )  # fmt: skip
    found = []
    for (state, _), own in groupby(
        range(len(cameras)), key=lambda i: (cameras.state[i], cameras.shot[i])
    ):
        frames: Sequence[int] = list(own)
        if state not in ("anchor", "followed"):
            first, last = frames[0], frames[-1]
            ends = cameras.frame[first], cameras.frame[last]
            found.append((*ends, len(frames), state, cameras.reason[first]))
    return shortened(
        MetricTable("gaps", pluralize(len(found), "gap"), columns, tuple(found)), _SHOWN
    )


def tracked_words(cameras: PackedCameras) -> str:
    """``430 of 436 frames have a camera (2 anchors, 420 followed, 8 bridged), 6 are lost``."""
    states = Counter(cameras.state)
    have = sum(states[state] for state in STATES[:3])
    return (
        f"{have} of {pluralize(len(cameras), 'frame')} have a camera"
        f" ({pluralize(states['anchor'], 'anchor')}, {states['followed']} followed,"
        f" {states['bridged']} bridged), {states.total() - have} lost"
    )


def season_table(matches: Sequence[MatchUnits]) -> MetricTable:
    """A row a match: its state, frames, units, speed, evidence, and when it changed last."""
    columns = (
        Column("match", "match"),
        Column("state", "state"),
        *map(count_column, ("frames", "tracked", "units", "failed")),
        Column("frames_per_cpu_s", "frames/s", "number", written=".1f"),
        metric_column(COVERAGE),
        Column("changed", "changed"),
    )
    rows = []
    for one in matches:
        speed = one.tracked / one.seconds if one.seconds else None
        changed = _clock(one.changed) if one.done or one.failed else None
        counts = one.frames or None, one.frames_tracked, one.done, one.failed
        rows.append((one.match, one.progress, *counts, speed, one.evidence, changed))
    title = pluralize(len(rows), "match", "matches")
    return shortened(MetricTable("season", title, columns, tuple(rows)), _SHOWN_MATCHES)


def _clock(time_s: float) -> str:
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(time_s))


def season_words(store: UnitStore, now: float, price: float | None = None) -> str:
    """How much is done, how fast it goes, and what is left.

    Args:
        now: seconds since 1970. price: of an hour of work in one process, for the costs.
    """
    matches = store.matches()
    opened = [one.frames for one in matches if one.frames]
    total = sum(opened) + (len(matches) - len(opened)) * (sum(opened) / max(len(opened), 1))
    done = sum(one.state == DONE for one in matches)
    tracked = sum(one.frames_tracked for one in matches)
    seconds = sum(one.seconds for one in matches)
    total = max(total, tracked)
    about = "about " if len(opened) < len(matches) else ""
    said = [
        f"{done} of {pluralize(len(matches), 'match', 'matches')} done, {tracked} of"
        f" {about}{total:.0f} frames tracked"
    ]
    recent, since = store.tracked_since(now - _RECENT_S)
    if recent:
        speed = recent / max(now - since, 1.0)
        said.append(f"{speed:.1f} frames/s, about {_duration((total - tracked) / speed)} left")
    hours = seconds / 3600
    left = (total - tracked) / tracked * hours if tracked else 0.0
    said.append(f"{hours:.1f} hours of work in one process, about {left:.1f} to come")
    if price is not None:
        said.append(f"cost {hours * price:.2f}, about {left * price:.2f} to come")
    return "; ".join(said)


def _duration(seconds: float) -> str:
    for unit, length in (("days", 86400.0), ("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 2 * length:
            return f"{seconds / length:.0f} {unit}"
    return f"{seconds:.0f} s"
