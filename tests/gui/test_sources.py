"""Several camera sources of one dataset: how they are kept, judged, drawn and remembered."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.metric.measure import measure
from procc_annotator.metric.score import score
from procc_annotator.session.audit import FrameAudit
from procc_annotator.session.camera_set import CameraSet
from tests.gui.conftest import Hand, MakeWindow

SETS = ("true", "bad", "pinhole")


@pytest.fixture
def annotated(sample_data: Path, tmp_path: Path) -> Path:
    """The sample's frames and cameras, to be changed at will."""
    folder = tmp_path / "sample"
    shutil.copytree(sample_data, folder, ignore=shutil.ignore_patterns("drawing", "*.py", ".procc"))
    return folder


@pytest.fixture
def audited(make_window: MakeWindow, annotated: Path, qtbot: QtBot) -> MainWindow:
    """The window on the sample with three sources, all frames audited; the first one is active."""
    window = make_window(annotated)
    for name in SETS:
        assert window.document.load_cameras(annotated / "cameras" / name)
    window.document.set_active_camera(0)
    window.document.go_to(1)
    settle(window, qtbot)
    return window


def settle(window: MainWindow, qtbot: QtBot) -> None:
    """Everything computed in the background has arrived."""
    document = window.document
    qtbot.waitUntil(lambda: not document.set_scores.running, timeout=20_000)
    qtbot.waitUntil(lambda: all(document.source_frames.of(s) is not None for s in document.sources))


def jac_here(window: MainWindow, name: str) -> float:
    """The JaC that the metric's own functions give the frame on screen under a set of cameras."""
    document = window.document
    path = next(s.path for s in document.camera_sets if s.path.name == name)
    found = CameraSet.open(path).camera(document.frame.name, document.setup.size)
    return score(measure(document.annotation, found.camera, document.setup), document.tau).jac


def source(window: MainWindow, name: str) -> CameraSource:
    return next(s for s in window.document.sources if s.name == name)


class TestAudits:
    def test_every_source_is_audited_whichever_is_active(self, audited: MainWindow) -> None:
        document = audited.document
        frame = document.frame.name
        for name in ("true", "bad"):
            audits = source(audited, name).audits
            assert isinstance(audits[frame], FrameAudit)
            assert audits[frame].jac_at(document.tau) == pytest.approx(
                jac_here(audited, name), abs=1e-6
            )
        assert len(source(audited, "true").audits) > len(source(audited, "bad").audits) > 0

    def test_the_mean_is_that_of_the_frames_at_any_threshold(self, audited: MainWindow) -> None:
        bad = source(audited, "bad")
        for tau in (2.0, 5.0, 17.3):
            values = [audit.jac_at(tau) for audit in bad.audits.values()]
            assert bad.mean_jac(tau) == pytest.approx(sum(values) / len(values), abs=1e-9)
        assert bad.mean_jac(2.0) < bad.mean_jac(20.0)

    def test_switching_computes_nothing_of_the_set_anew(
        self, audited: MainWindow, qtbot: QtBot
    ) -> None:
        document = audited.document
        before = dict(source(audited, "bad").audits)
        document.set_active_camera(1)
        assert not document.set_scores.running
        assert source(audited, "bad").audits == before
        assert dict(document.frame_scores) == {
            name: audit.jac_at(document.tau) for name, audit in before.items()
        }

    def test_an_edit_is_audited_under_every_source(
        self, audited: MainWindow, hand_on: Callable[[MainWindow], Hand], qtbot: QtBot
    ) -> None:
        document = audited.document
        frame = document.frame.name
        before = {s.name: s.audits[frame] for s in document.sources if frame in s.audits}
        told: list[object] = []
        document.sourceAuditsChanged.connect(told.append)
        document.select_class("Circle central")
        hand = hand_on(audited)
        for point in ((100.0, 600.0), (180.0, 620.0), (300.0, 640.0)):
            hand.click(*point)
        audited.canvas.key("Enter")
        bad = source(audited, "bad")
        assert document.active_source.audits[frame] is not before["true"]  # at once
        qtbot.waitUntil(lambda: bad.audits[frame] is not before["bad"])
        for name in ("true", "bad"):
            assert source(audited, name).audits[frame].jac_at(document.tau) == pytest.approx(
                jac_here(audited, name), abs=1e-6
            )
        assert {document.active_source, bad} <= set(told)

    def test_terms_apply_to_every_source(self, audited: MainWindow, qtbot: QtBot) -> None:
        document = audited.document
        document.set_protocol("procc")
        settle(audited, qtbot)
        for name in ("true", "bad"):
            assert source(audited, name).audits[document.frame.name].jac_at(
                document.tau
            ) == pytest.approx(jac_here(audited, name), abs=1e-6)

    def test_a_damaged_camera_is_known_by_its_frame(
        self, make_window: MakeWindow, annotated: Path, qtbot: QtBot
    ) -> None:
        (annotated / "cameras" / "bad" / "camera_00003.json").write_text("{")
        window = make_window(annotated)
        window.document.load_cameras(annotated / "cameras" / "bad")
        settle(window, qtbot)
        (bad,) = window.document.sources
        assert list(bad.problems) == ["00003"]
        assert "camera_00003.json" in bad.problems["00003"]
        assert "00002" in bad.audits
