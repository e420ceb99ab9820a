"""Killed without warning while saving, the program never leaves a broken or an older file."""

import json
import os
import random
import signal
import sys
import time
from pathlib import Path

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation
from procc_annotator.formats.atomic import write_atomic

TRIALS = 12


def version(number: int) -> FrameAnnotation:
    """An annotation that tells its number in every point, long enough to be torn."""
    points = tuple(Point(number, i / 400) for i in range(400))
    return FrameAnnotation((Polyline("Circle central", points),))


def save_until_killed(path: Path, acknowledged: int, start: int) -> None:
    """Child: save numbered versions and tell the parent after each save."""
    number = start
    while True:
        number += 1
        write_atomic(path, write_annotation(version(number)))
        os.write(acknowledged, number.to_bytes(8, "little"))


def wait_for_first_save(reader: int) -> bytes:
    return os.read(reader, 8)


@pytest.mark.laps
@pytest.mark.skipif(sys.platform == "win32", reason="needs fork and SIGKILL")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_kill_9_during_saving_loses_nothing_that_was_saved(tmp_path, lap):
    field = load_field()
    path = tmp_path / "00001.json"
    moments = random.Random(20240617 + lap)
    last = 0
    for _ in range(TRIALS):
        reader, writer = os.pipe()
        child = os.fork()
        if child == 0:  # pragma: no cover - the child never returns
            try:
                save_until_killed(path, writer, last)
            finally:
                os._exit(1)
        os.close(writer)
        told = wait_for_first_save(reader)
        moment = time.perf_counter() + moments.uniform(0, 0.01)
        while time.perf_counter() < moment:
            pass
        os.kill(child, signal.SIGKILL)
        _, status = os.waitpid(child, 0)
        assert os.WIFSIGNALED(status)
        while chunk := os.read(reader, 1 << 16):
            told += chunk
        os.close(reader)
        acknowledged = int.from_bytes(told[len(told) // 8 * 8 - 8 : len(told) // 8 * 8], "little")
        annotation = read_annotation(path.read_bytes(), path=str(path), field=field)
        (polyline,) = annotation.polylines
        last = int(polyline.points[0].u)
        assert last >= acknowledged > 0
        assert annotation == version(last)
    leftovers = [p for p in tmp_path.iterdir() if p != path]
    assert all(p.name.startswith(".") and p.name.endswith(".tmp") for p in leftovers)
    assert json.loads(path.read_text())
