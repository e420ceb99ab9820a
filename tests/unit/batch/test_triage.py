"""Verdicts outlive the program, also in older databases; worst first; the exported table."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.triage import (
    judge_verdict,
    next_worst,
    set_disagreement,
    worst_frames_first,
)
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.filter_query import FrameFacts, parse_query
from procc_annotator.dataset.records import (
    FaultParty,
    Verdict,
)
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.metrics.error_maps import disagreement
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.window_tables import verdicts_csv

FIELD = load_field("soccer")
SETUP = EvaluationSetup(FIELD)
BAD = "auto:cameras/bad"


class TestFilter:
    FACTS = FrameFacts("f", "done", (), 0, 0, "", False, False, False, lambda tau: None)

    @pytest.mark.parametrize(
        ("query", "verdicts", "matches"),
        [
            ("verdict:camera", {"camera"}, True),
            ("verdict:camera", {"annotation"}, False),
            ("verdict:camera,annotation", {"annotation", "fine"}, True),
            ("verdict:none", set(), True),
            ("verdict:none", {"fine"}, False),
            ("-verdict:none", {"fine"}, True),
            ("-verdict:fine", set(), True),
            ("verdict:", {"fine"}, True),  # not finished yet
        ],
    )
    def test_by_verdict(self, query, verdicts, matches) -> None:
        from dataclasses import replace

        facts = replace(self.FACTS, verdicts=frozenset(verdicts))
        assert parse_query(query, FIELD).matches(facts) is matches

    def test_what_is_no_verdict_is_told(self) -> None:
        with pytest.raises(UsageError, match=r"'guilty' is not a verdict; choose one of camera"):
            parse_query("verdict:guilty", FIELD)


class TestCheckFilter:
    FACTS = TestFilter.FACTS

    @pytest.mark.parametrize(
        ("query", "findings", "matches"),
        [
            ("check:error", {"error", "hint"}, True),
            ("check:error", {"hint"}, False),
            ("check:warning,hint", {"hint"}, True),
            ("check:none", set(), True),
            ("check:none", {"hint"}, False),
            ("-check:error", {"hint"}, True),
            ("check:error", None, False),
            ("-check:error", None, False),  # nobody knows
            ("check:none", None, False),
            ("check:unchecked", None, True),
            ("check:error,unchecked", None, True),
            ("check:unchecked", {"error"}, False),
            ("-check:unchecked", {"error"}, True),
            ("check:", None, True),  # not finished yet
        ],
    )
    def test_by_what_the_label_check_found(self, query, findings, matches) -> None:
        from dataclasses import replace

        known = None if findings is None else frozenset(findings)
        facts = replace(self.FACTS, findings=known)
        assert parse_query(query, FIELD).matches(facts) is matches

    def test_what_is_no_finding_is_told(self) -> None:
        with pytest.raises(UsageError, match=r"'fatal' is not a finding; choose one of error"):
            parse_query("check:fatal", FIELD)


INDEX = {"a": 0, "b": 1, "c": 2, "d": 3}


class TestOrder:
    def test_worst_first_and_alike_in_the_order_of_the_set(self) -> None:
        values = {"d": 0.5, "b": 0.5, "a": 0.9, "gone": 0.0}
        assert worst_frames_first(values, INDEX, low=True) == [1, 3, 0]
        assert worst_frames_first(values, INDEX, low=False) == [0, 1, 3]

    def test_a_walk_visits_every_frame_once_and_begins_again(self) -> None:
        order = [1, 3, 0]
        assert next_worst(order, -1, 2) == 0
        assert next_worst(order, 0, 1) == 1
        assert next_worst(order, 1, 3) == 2
        assert next_worst(order, 2, 0) == 0

    def test_a_walk_goes_on_where_it_was_left_and_never_stays(self) -> None:
        order = [1, 3, 0]
        assert next_worst(order, 0, 7) == 1  # somebody looked at another frame meanwhile
        assert next_worst(order, 0, 3) == 2  # and this one is on screen already
        assert next_worst(order, -1, 1) == 1
        assert next_worst([2], -1, 2) is None
        assert next_worst([], -1, 2) is None


class TestCompare:
    def test_the_median_is_that_of_the_map(self, sample_data) -> None:
        true, bad = (CameraSet.open(sample_data / "cameras" / n) for n in ("true", "bad"))
        found = set_disagreement(["00001", "00002", "no such"], true, bad, SETUP)
        assert found.finished
        assert found.skipped == 1
        exact = disagreement(
            true.camera("00002", SETUP.size).camera,
            bad.camera("00002", SETUP.size).camera,
            FIELD,
            SETUP.size,
        )
        assert found.metres["00002"] == exact.statistics.metres.median
        assert found.metres["00002"] > 0.05

    def test_a_source_agrees_with_itself(self, sample_data) -> None:
        true = CameraSet.open(sample_data / "cameras" / "true")
        found = set_disagreement(["00001"], true, true, SETUP)
        assert found.metres["00001"] == pytest.approx(0.0, abs=1e-9)

    def test_it_can_be_stopped(self, sample_data) -> None:
        true = CameraSet.open(sample_data / "cameras" / "true")
        calls = iter([False, True])
        found = set_disagreement(
            ["00001", "00002"], true, true, SETUP, cancelled=lambda: next(calls)
        )
        assert not found.finished
        assert list(found.metres) == ["00001"]


class TestExport:
    def read(self, folder: Path, name: str):
        path = folder / f"{name}.json"
        return read_annotation(path.read_bytes(), path=str(path), field=FIELD)

    def test_the_figures_are_those_of_the_metric(self, sample_data) -> None:
        cameras = CameraSet.open(sample_data / "cameras" / "bad")
        verdict = Verdict(
            "00002", "bad", BAD, FaultParty.CAMERA, "Anna", 1_700_000_000.0, '=1+1 "x"'
        )
        found = judge_verdict(verdict, cameras, lambda n: self.read(sample_data, n), SETUP, 5.0)
        measured = measure(
            self.read(sample_data, "00002"), cameras.camera("00002", SETUP.size).camera, SETUP
        )
        judged = score(measured, 5.0)
        assert found.jac == judged.jac
        assert found.largest_px == judged.max_error
        (row,) = csv.DictReader(io.StringIO(verdicts_csv([found], FIELD, SETUP, 5.0).decode()))
        worst = max(
            (e for e in judged.elements if e.max_distance is not None),
            key=lambda e: e.max_distance,
        )
        assert row["frame"] == "00002"
        assert row["source"] == "bad"
        assert row["verdict"] == "camera"
        assert float(row["jac@5px"]) == pytest.approx(judged.jac, abs=1e-5)
        assert float(row["largest_error_px"]) == pytest.approx(judged.max_error, rel=1e-5)
        assert row["worst_element"] == FIELD.title_of(worst.annotated_name)
        assert row["author"] == "Anna"
        assert row["time"] == "2023-11-14T22:13:20Z"
        assert row["comment"] == '\'=1+1 "x"'
        assert row["terms"] == "soccernet, 960x540"

    def test_a_frame_annotated_as_empty_is_judged(self, sample_data) -> None:
        cameras = CameraSet.open(sample_data / "cameras" / "bad")
        verdict = Verdict("00002", "bad", BAD, FaultParty.CAMERA, "Anna", 0.0)
        found = judge_verdict(verdict, cameras, lambda n: FrameAnnotation(()), SETUP, 5.0)
        assert (found.jac, found.largest_px, found.worst_element) == (0.0, None, "")
        assert found.problem == ""

    def test_without_figures_it_says_why(self, sample_data) -> None:
        cameras = CameraSet.open(sample_data / "cameras" / "bad")
        verdict = Verdict("00002", "bad", BAD, FaultParty.CAMERA, "Anna", 0.0)
        missing = judge_verdict(verdict, None, lambda n: None, SETUP, 5.0)
        assert missing.problem == "the source cameras/bad is not loaded"
        found = judge_verdict(verdict, cameras, lambda n: None, SETUP, 5.0)
        assert "not annotated" in found.problem
        (row,) = csv.DictReader(io.StringIO(verdicts_csv([found], FIELD, SETUP, 5.0).decode()))
        assert row["jac@5px"] == ""
        assert "not annotated" in row["problem"]
