"""Verdicts outlive the program, also in older databases; worst first; the exported table."""

from __future__ import annotations

import csv
import io
import sqlite3
from collections.abc import Callable, Iterator
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
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.database.schema import MIGRATIONS, stored
from procc_annotator.dataset.filter_query import FrameFacts, parse_query
from procc_annotator.dataset.records import (
    FaultParty,
    Status,
    Verdict,
    path_of,
    place_by_name,
    place_of,
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
Open = Callable[[], WorkspaceDatabase]


@pytest.fixture
def opened(tmp_path) -> Iterator[Open]:
    held: list[WorkspaceDatabase] = []

    def open_() -> WorkspaceDatabase:
        held.append(WorkspaceDatabase.open(tmp_path, "Anna"))
        return held[-1]

    yield open_
    for one in held:
        one.close()


class TestDatabase:
    def test_verdicts_are_there_again(self, opened) -> None:
        database = opened()
        database.set_verdict("f1", "NBJW", FaultParty.CAMERA, "the roll is off")
        database.set_verdict("f1", "CARWC", FaultParty.FINE)
        database.set_verdict("f\udcff2", "NBJW", FaultParty.ANNOTATION)
        database.set_verdict("f3", "NBJW", FaultParty.FINE)
        database.set_verdict("f3", "NBJW", None)
        database.close()
        again = opened()
        first = again.verdicts("f1")
        assert first[place_by_name("NBJW")].fault is FaultParty.CAMERA
        assert first[place_by_name("NBJW")].comment == "the roll is off"
        assert first[place_by_name("NBJW")].author == "Anna"
        assert first[place_by_name("CARWC")].fault is FaultParty.FINE
        assert set(again.all_verdicts()) == {"f1", "f\udcff2"}

    def test_another_window_sees_them_and_that_they_are_gone(self, opened) -> None:
        mine, theirs = opened(), opened()
        mine.set_verdict("f1", "NBJW", FaultParty.CAMERA)
        assert mine.flush()
        assert "f1" in theirs.reload()
        assert theirs.verdicts("f1")[place_by_name("NBJW")].fault is FaultParty.CAMERA
        mine.set_verdict("f1", "NBJW", None)
        assert mine.flush()
        assert "f1" in theirs.reload()
        assert not theirs.verdicts("f1")

    def test_a_database_of_the_version_before_goes_on(self, tmp_path, opened) -> None:
        database = opened()
        database.set_status("f1", Status.DONE)
        database.add_comment("f1", "left goal")
        database.close()
        path = tmp_path / ".procc" / "workspace.db"
        with sqlite3.connect(path) as older:  # as it was before there were verdicts
            older.execute("DROP TABLE source_verdict")
            older.execute("DROP TABLE not_visible")
            older.execute("PRAGMA user_version = 1")
        older.close()
        assert len(MIGRATIONS) == 4
        again = opened()
        assert again.notices == ()
        assert again.record("f1").status is Status.DONE
        assert [c.text for c in again.comments("f1")] == ["left goal"]
        again.set_verdict("f1", "NBJW", FaultParty.ANNOTATION)
        again.close()
        assert opened().verdicts("f1")[place_by_name("NBJW")].fault is FaultParty.ANNOTATION

    def test_verdicts_by_name_of_the_version_before_go_on(self, tmp_path, opened) -> None:
        opened().close()
        self.make_older(tmp_path / ".procc" / "workspace.db")
        again = opened()
        assert again.notices == ()
        assert again.verdicts("f1")[place_by_name("NBJW")].source == "NBJW"
        assert again.verdicts("f2")[place_by_name("N\udcff")].fault is FaultParty.FINE

    def test_verdicts_of_a_damaged_file_of_the_version_before_are_saved(
        self, tmp_path, opened
    ) -> None:
        opened().close()
        path = tmp_path / ".procc" / "workspace.db"
        self.make_older(path)
        with sqlite3.connect(path) as damaged:
            damaged.execute("DROP TABLE draft")
        damaged.close()
        again = opened()
        assert "set aside" in again.notices[0]
        assert again.verdicts("f1")[place_by_name("NBJW")].fault is FaultParty.CAMERA

    @staticmethod
    def make_older(path: Path) -> None:
        """As it was before sources were known by their places."""
        with sqlite3.connect(path) as older:
            older.execute("DROP TABLE source_verdict")
            older.execute("DROP TABLE not_visible")
            for statement in MIGRATIONS[1]:
                older.execute(statement)
            for frame, source, fault in (("f1", "NBJW", "camera"), ("f2", "N\udcff", "fine")):
                row = (frame, stored(source), fault)
                older.execute("INSERT INTO verdict VALUES(?, ?, ?, 'Anna', 1.5, '')", row)
            older.execute("PRAGMA user_version = 2")
        older.close()

    def test_a_new_name_goes_to_the_file_and_to_other_windows(self, opened) -> None:
        mine, theirs = opened(), opened()
        mine.set_verdict("f1", "bad", FaultParty.CAMERA, place=BAD)
        mine.set_verdict("f2", "bad", FaultParty.FINE, place="auto:elsewhere/bad")
        mine.set_verdict("f3", "bad", FaultParty.FINE, "from before")  # only the name is known
        mine.rename_source(BAD, "bad", "vendor X")
        assert mine.flush()
        theirs.reload()
        mine.close()
        for database in (mine, theirs, opened()):
            assert database.verdicts("f1")[BAD].source == "vendor X"
            assert database.verdicts("f2")["auto:elsewhere/bad"].source == "bad"
            (moved,) = database.verdicts("f3").values()
            assert (moved.source, moved.place, moved.comment) == ("vendor X", BAD, "from before")

    def test_a_new_verdict_takes_the_place_of_one_by_name(self, opened) -> None:
        database = opened()
        database.set_verdict("f1", "bad", FaultParty.FINE)
        database.set_verdict("f1", "bad", FaultParty.CAMERA, place=BAD)
        assert [v.fault for v in database.verdicts("f1").values()] == [FaultParty.CAMERA]

    def test_places(self, tmp_path) -> None:
        dataset = tmp_path / "set" / "images"
        for path, place in (
            (dataset / "cameras" / "bad", "auto:cameras/bad"),
            (dataset.parent / "cameras", "auto:../cameras"),
            (tmp_path / "bad", f"auto:{(tmp_path / 'bad').resolve().as_posix()}"),
        ):
            assert place_of(path, "auto", dataset) == place
            assert path_of(place) == place.removeprefix("auto:")
        assert path_of(place_by_name("bad")) == ""

    def test_they_are_written_into_a_file_begun_anew(self, tmp_path, opened) -> None:
        database = opened()
        database.set_verdict("f1", "NBJW", FaultParty.CAMERA)
        assert database.flush()
        (tmp_path / ".procc" / "workspace.db").unlink()
        database.set_status("f2", Status.DONE)
        assert database.flush()
        database.close()
        assert opened().verdicts("f1")[place_by_name("NBJW")].fault is FaultParty.CAMERA


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
