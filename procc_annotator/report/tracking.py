"""Tables of tracked cameras and of the units of a run."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from itertools import groupby

import numpy as np

from procc_annotator.batch.unit_store import DONE, FAILED, WAITING, MatchUnits, UnitStore
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
        *map(count_column, ("frames", "tracked", "cameras", "units", "failed")),
        Column("frames_per_cpu_s", "frames/s", "number", written=".1f"),
        metric_column(COVERAGE),
        Column("changed", "changed"),
    )
    rows = []
    for one in matches:
        speed = one.tracked / one.seconds if one.seconds else None
        changed = None if one.progress == WAITING else _clock(one.changed)
        counts = one.frames or None, one.frames_tracked, one.cameras, one.done, one.failed
        rows.append((one.match, one.progress, *counts, speed, one.evidence, changed))
    title = pluralize(len(rows), "match", "matches")
    return shortened(MetricTable("season", title, columns, tuple(rows)), _SHOWN_MATCHES)


def _clock(time_s: float) -> str:
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(time_s))


def season_progress(
    matches: Sequence[MatchUnits], store: UnitStore, now: float, price: float | None
) -> tuple[str, dict[str, float | None]]:
    """How much is done ``now`` (seconds since 1970), how fast it goes, what is left, and what it
    costs at the price of an hour of work in one process: in words, and as numbers by name."""
    done, failed = (sum(one.progress == state for one in matches) for state in (DONE, FAILED))
    tracked, seconds = sum(m.frames_tracked for m in matches), sum(m.seconds for m in matches)
    wanted = [one for one in matches if one.progress != FAILED]
    opened = [one.frames for one in wanted if one.frames]
    total = sum(opened) + (len(wanted) - len(opened)) * sum(opened) / max(len(opened), 1)
    left = max(total - tracked, 0.0) if done + failed < len(matches) else 0.0
    about = "about " if len(opened) < len(wanted) else ""
    total = max(total, tracked)
    said = [
        f"{done} of {pluralize(len(matches), 'match', 'matches')} done, {tracked} of"
        f" {about}{total:.0f} frames tracked"
    ]
    if failed:
        said[0] += f", {pluralize(failed, 'match', 'matches')} failed"
    recent, since = store.tracked_since(now - _RECENT_S)
    speed = recent / max(now - since, 1.0) if recent and left else None
    if speed:
        said.append(f"{speed:.1f} frames/s, about {_duration(left / speed)} left")
    hours = seconds / 3600
    to_come = left / tracked * hours if tracked else 0.0
    said.append(f"{hours:.1f} hours of work in one process, about {to_come:.1f} to come")
    if price is not None:
        said.append(f"cost {hours * price:.2f}, about {to_come * price:.2f} to come")
    return "; ".join(said), {
        "matches": len(matches), "matches_done": done, "matches_failed": failed,
        "frames": round(total), "frames_tracked": tracked, "frames_per_s": speed,
        "seconds_left": left / speed if speed else None, "hours": hours, "hours_left": to_come,
        "cost": price and hours * price, "cost_left": price and to_come * price,
    }  # fmt: skip


def _duration(seconds: float) -> str:
    for unit, length in (("days", 86400.0), ("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 2 * length:
            return f"{seconds / length:.0f} {unit}"
    return f"{seconds:.0f} s"
