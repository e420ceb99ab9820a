"""How often a camera is found without a click, and how often that is sure and wrong:
``pytest tests/bench/no_clicks/test_bench_proposals.py --benchmark-only -s``.

A camera is right if at least 70 % of the listed elements lie within 10 px of where it shows them,
at 960x540. ``DRAWN=200`` draws so many frames of each sport (otherwise 50). Times are those of the
processor.
"""

import os
import time
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.single_image.proposal import (
    SURE,
    KnownPosition,
    Proposal,
    cluster_fit_positions,
)
from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from tests.bench.no_clicks.clips import hall_clips, is_right, soccer_clips
from tests.bench.sports.views import Views
from tests.drawn_shots import ARENAS, Look, draw, random_camera, stage_of

DRAWN = int(os.environ.get("DRAWN", "50"))
DRAWN_SIZE = (960, 540)
# As pictures that were broadcast: with loss.
BROADCAST = Look(noise=3.0, jpeg_quality=70)


@dataclass
class Tally:
    """What proposals came to.

    Attributes:
        counts: (state, whether it is right) -> frames.
        seconds: of each.
        wrong: names of those that are sure and wrong.
    """

    counts: Counter[tuple[str, bool]] = field(default_factory=Counter)
    seconds: list[float] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)

    def add(self, name: str, found: Proposal, seconds: float, *, right: bool) -> None:
        self.counts[found.state, right] += 1
        self.seconds.append(seconds)
        if found.state == SURE and not right:
            self.wrong.append(name)

    def plus(self, others: "Iterable[Tally]") -> "Tally":
        total = Tally(Counter(self.counts), list(self.seconds), list(self.wrong))
        for other in others:
            total.counts.update(other.counts)
            total.seconds += other.seconds
            total.wrong += other.wrong
        return total

    @property
    def frames(self) -> int:
        return sum(self.counts.values())

    @property
    def right(self) -> int:
        return sum(n for (_, right), n in self.counts.items() if right)

    @property
    def sure(self) -> int:
        return self.counts[SURE, True] + self.counts[SURE, False]

    def row(self) -> str:
        """For a table: frames, right, wrong, none; sure and of those wrong; seconds."""
        none = self.counts["none", False]
        frames = max(self.frames, 1)
        share = 100 * len(self.wrong) / self.sure if self.sure else 0.0
        s = self.seconds or [0.0]
        return (
            f"{self.frames} | {100 * self.right / frames:.0f} % |"
            f" {100 * (self.frames - self.right - none) / frames:.0f} % |"
            f" {100 * none / frames:.0f} % | {100 * self.sure / frames:.0f} % |"
            f" {len(self.wrong)} ({share:.1f} %) | {np.median(s):.2f} ({max(s):.2f})"
        )


_HEAD = "| | frames | right | wrong | none | sure | sure and wrong | s, median (most) |"


def proposed(
    picture: PixelArray, shown: Field, known: tuple[KnownPosition, ...] = ()
) -> tuple[Proposal, float]:
    """A proposal, and the processor time it took."""
    began = time.process_time()
    found = propose_camera(picture, shown, known=known)
    return found, time.process_time() - began


@pytest.mark.parametrize("known", [False, True], ids=["nothing known", "position known"])
def test_clips(benchmark, shared_data, known):
    """Frames of real shots; also with the positions that the sure ones of a shot agree on."""
    soccer = load_field("soccer")

    def run() -> dict[str, Tally]:
        rows = {}
        for clip in soccer_clips(shared_data):
            rows[clip.name] = tally = Tally()
            positions: tuple[KnownPosition, ...] = ()
            if known:
                first = [proposed(clip.frame(n), soccer)[0] for n in clip.truth]
                positions = cluster_fit_positions([p.fit for p in first if p.state == SURE], soccer)
            for number, truth in clip.truth.items():
                found, seconds = proposed(clip.frame(number), soccer, positions)
                right = is_right(truth, found.fit.camera, clip.size, soccer)
                tally.add(f"{clip.name} {number}", found, seconds, right=right)
            if tally.frames:
                print(f"| {clip.name} | {tally.row()} |", flush=True)
        return rows

    print(f"\n{_HEAD}")
    rows = benchmark.pedantic(run, rounds=1)
    total = Tally().plus(rows.values())
    print(f"| all | {total.row()} |\nsure and wrong: {', '.join(total.wrong) or 'none'}")
    assert total.right >= 0.9 * total.frames
    assert len(total.wrong) <= 0.01 * total.sure


def test_other_sports(benchmark, shared_data):
    """Ten frames of each shot of another sport."""

    def run() -> dict[str, Tally]:
        rows = {}
        for clip in hall_clips(shared_data):
            shown = load_field(clip.field)
            rows[clip.name] = tally = Tally()
            for number, truth in clip.truth.items():
                found, seconds = proposed(clip.frame(number), shown)
                right = is_right(truth, found.fit.camera, clip.size, shown)
                tally.add(f"{clip.name} {number}", found, seconds, right=right)
            print(f"| {clip.name} | {tally.row()} |", flush=True)
        return rows

    print(f"\n{_HEAD}")
    total = Tally().plus(benchmark.pedantic(run, rounds=1).values())
    print(f"| all | {total.row()} |\nsure and wrong: {', '.join(total.wrong) or 'none'}")
    assert not total.wrong


@pytest.mark.parametrize("name", ARENAS)
def test_drawn_frames(benchmark, name):
    """Random cameras that the field file allows, pictures with people, noise and loss."""
    stage = stage_of(name)
    views = Views(stage.field)

    def run() -> tuple[Tally, Tally]:
        beside, above = Tally(), Tally()
        rng = np.random.default_rng(7)
        for number in range(DRAWN):
            camera = random_camera(stage.field, rng, DRAWN_SIZE)
            truth: FrameAnnotation = views.clicks(camera, rng, 0.0)
            picture = draw(stage, camera, DRAWN_SIZE, seed=number + 1, look=BROADCAST)
            found, seconds = proposed(picture, stage.field)
            right = is_right(truth, found.fit.camera, DRAWN_SIZE, stage.field)
            looks_down = camera.tilt_rad < np.radians(30)
            (above if looks_down else beside).add(f"{name} {number}", found, seconds, right=right)
        return beside, above

    beside, above = benchmark.pedantic(run, rounds=1)
    print(f"\n{_HEAD}\n| {name}, beside the field | {beside.row()} |")
    if above.frames:
        print(f"| {name}, looking down | {above.row()} |")
    print(f"sure and wrong: {', '.join(beside.wrong + above.wrong) or 'none'}")
