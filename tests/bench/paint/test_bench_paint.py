"""How well paint is found on real frames: ``pytest tests/bench/paint --benchmark-only -s``.

Snapping from 4 px beside the paint, regularising and accepted ghosts, against places measured by
eye (`truth`). Printed are tables; speeds are processor times.
"""

from collections import defaultdict

import numpy as np
import pytest

from procc_annotator.assist.line_evidence import ExpectedLines
from tests.bench.paint.measures import (
    Accepted,
    Regular,
    Snaps,
    accepted,
    camera_of,
    regular,
    snapping,
)
from tests.bench.paint.truth import truth_frames


@pytest.mark.parametrize("given", ["nothing", "direction", "camera"])
def test_snapping(benchmark, shared_data, given):
    """Knowing the class alone, the line's direction as well, or the frame's camera."""

    def run() -> dict[tuple[str, str], Snaps]:
        rows: dict[tuple[str, str], Snaps] = defaultdict(Snaps)
        for frame in truth_frames():
            paint = (
                camera_of(frame) if given == "camera" else ExpectedLines(frame.field, frame.size[0])
            )
            directed = given == "direction"
            found = snapping(frame, frame.picture(shared_data), paint, directed=directed)
            for kind, snaps in found.items():
                row = rows[frame.sport, kind]
                row.away += snaps.away
                row.stayed += snaps.stayed
                row.seconds += snaps.seconds
        return rows

    rows = benchmark.pedantic(run, rounds=1)
    lines = rows["soccer", "line"]
    assert len(lines.away) > lines.stayed
    assert np.median(lines.away) < 0.5
    print(f"\nsnapping, known: {given}")
    print("| sport | kind | clicks | median px | <= 1 px | wrong | stayed |")
    for (sport, kind), row in sorted(rows.items()):
        if row.away or row.stayed:
            print(f"| {sport} | {kind} | {row.row()} |")
    seconds = [s for row in rows.values() for s in row.seconds]
    print(f"a snap: {1e3 * np.median(seconds):.2f} ms, 95 % {1e3 * np.percentile(seconds, 95):.2f}")


def test_regularising(benchmark, shared_data):
    """Every element of every frame, clicked by a hand."""

    def run() -> dict[str, Regular]:
        rng, rows = np.random.default_rng(13), defaultdict(Regular)
        for frame in truth_frames():
            found, row = regular(frame, frame.picture(shared_data), rng), rows[frame.sport]
            row.clicks += found.clicks
            row.lost += found.lost
            row.lines += found.lines
            row.curves += found.curves
            row.seconds.append(sum(found.seconds))
        return rows

    rows = benchmark.pedantic(run, rounds=1)
    print("\n| sport | clicks | lost | lines median px (95 %) | curves | ms a frame (most) |")
    for sport, row in sorted(rows.items()):
        assert row.lost == 0, sport
        ms = 1e3 * np.array(row.seconds)
        print(
            f"| {sport} | {row.clicks} | {row.lost} | {_spread(row.lines)} | {_spread(row.curves)}"
            f" | {np.median(ms):.0f} ({ms.max():.0f}) |"
        )


def test_accepted_ghosts(benchmark, shared_data):
    """Four elements clicked, all ghosts accepted."""

    def run() -> dict[str, Accepted]:
        rng, rows = np.random.default_rng(13), defaultdict(Accepted)
        for frame in truth_frames():
            found = accepted(frame, frame.picture(shared_data), rng)
            row = rows[frame.sport]
            row.ghosts += found.ghosts
            row.wrong += found.wrong
            row.interior += found.interior
            row.ends += found.ends
        return rows

    rows = benchmark.pedantic(run, rounds=1)
    assert rows["soccer"].ghosts > 0
    assert np.median(rows["soccer"].interior) < 0.5
    print("\n| sport | ghosts | interior median px (95 %) | ends <= 2 px | median (95 %) | wrong |")
    for sport, row in sorted(rows.items()):
        ends = np.array(row.ends)
        right = f"{(ends <= 2.0).mean():.1%} of {len(ends)}" if len(ends) else "-"
        print(
            f"| {sport} | {row.ghosts} | {_spread(row.interior)} | {right} | {_spread(row.ends)}"
            f" | {len(row.wrong)} |"
        )
        for line in row.wrong:
            print(f"    {line}")


def _spread(values: list[float]) -> str:
    return f"{np.median(values):.2f} ({np.percentile(values, 95):.2f})" if values else "-"
