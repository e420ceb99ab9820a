"""Pairing and bad files of two annotators' sets; known noise on real annotations comes out."""

from __future__ import annotations

import json
import shutil
import unicodedata
import zipfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.batch.agreement import AgreementRun, ConsensusResult, ConsensusRun
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.agreement import AgreementAccumulator, AgreementSummary

LINE = {"Middle line": [{"x": 0.5, "y": 0.4}, {"x": 0.5, "y": 0.6}]}
FIELD = load_field("soccer")
SIZE = (960, 540)
Change = Callable[[str, dict[str, Any]], dict[str, Any] | None]


@pytest.fixture
def folders(tmp_path) -> tuple[Path, Path]:
    both = tmp_path / "a", tmp_path / "b"
    for folder in both:
        folder.mkdir()
        for name in ("1", "2", "10"):
            (folder / f"{name}.json").write_text(json.dumps(LINE))
    return both


def run(a: Path, b: Path, thresholds=(5.0,)) -> AgreementRun:
    return AgreementRun(open_source(a), open_source(b), FIELD, SIZE, thresholds)


def summary(compared: AgreementRun, results: Iterable[ConsensusResult]) -> AgreementSummary:
    sums = AgreementAccumulator(compared.thresholds, *compared.alone)
    for result in results:
        if result.agreement is not None:
            sums.add(result.name, result.agreement)
    return sums.summary()


def several(*folders: Path) -> ConsensusRun:
    return ConsensusRun([open_source(folder) for folder in folders], FIELD, SIZE, (5.0,))


def test_frames_are_paired_by_name_in_natural_order(folders) -> None:
    a, b = folders
    (a / "1.json").rename(a / "11.json")
    (b / "jac.json").write_text("{}")  # what the program itself writes there
    compared = run(a, b)
    assert compared.total == 2
    assert compared.names == ("2", "10")
    assert (compared.only_a, compared.only_b) == (("11",), ("1",))
    found = summary(compared, list(compared))
    assert (found.frames, found.frames_only_a, found.frames_only_b) == (2, ("11",), ("1",))
    assert found.mean_jac == {5.0: 1.0}
    assert compared.describe() == "soccer, 960x540"


def written(folder: Path, *names: str) -> Path:
    for name in names:
        path = folder / f"{name}.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(LINE))
    return folder


def test_the_order_of_two_does_not_matter_where_one_has_a_single_folder(tmp_path) -> None:
    season = written(tmp_path / "season", "g1/1", "g2/1")
    match = written(tmp_path / "match", "g2/1")
    there = run(season, match)
    assert (there.total, there.only_a, there.only_b) == (1, ("g1/1",), ())
    back = run(match, season)
    assert (back.total, back.only_a, back.only_b) == (1, (), ("g1/1",))
    three = several(season, match, match)
    assert [frame.name for frame in three.frames] == ["g2/1"]
    assert three.alone == (("g1/1",), (), ())
    again = several(match, season, match)
    assert [len(frame.files) - frame.files.count(None) for frame in again.frames] == [3]


def test_a_frame_counts_once_however_its_letters_are_composed(tmp_path) -> None:
    composed, apart = (unicodedata.normalize(form, "café_1") for form in ("NFC", "NFD"))
    names = (composed, apart, composed)
    found = several(*(written(tmp_path / f"{at}", name) for at, name in enumerate(names)))
    assert [frame.name for frame in found.frames] == [composed]
    assert None not in found.frames[0].files


def test_a_bad_file_does_not_stop_the_set(folders) -> None:
    a, b = folders
    (a / "1.json").write_text("{")
    (b / "1.json").write_text("[]")
    (b / "2.json").unlink()
    (b / "2.json").mkdir()
    compared = run(a, b)
    results = {r.name: r for r in compared}
    assert [len(r.errors) for r in results.values()] == [2, 1, 0]
    assert str(a / "1.json") in results["1"].errors[0]
    assert str(b / "1.json") in results["1"].errors[1]
    assert results["1"].agreement is None
    assert results["10"].agreement is not None
    assert summary(compared, results.values()).frames == 1


def test_an_archive_is_as_good_as_a_folder(folders, tmp_path) -> None:
    a, b = folders
    archive = tmp_path / "b.zip"
    with zipfile.ZipFile(archive, "w") as packed:
        for path in b.iterdir():
            packed.write(path, f"test/{path.name}")
    assert [r.name for r in run(a, archive)] == ["1", "2", "10"]


def test_nothing_to_do_is_said_before_any_work(folders, tmp_path) -> None:
    a, b = folders
    empty = tmp_path / "empty"
    empty.mkdir()
    with pytest.raises(UsageError, match="no annotation"):
        run(a, empty)
    for path in list(b.iterdir()):
        path.rename(b / f"frame_{path.name}")
    with pytest.raises(UsageError, match=r"'1'.*'frame_1'"):
        run(a, b)
    with pytest.raises(UsageError, match="threshold"):
        run(a, a, [0.0])
    with pytest.raises(UsageError, match="too small"):
        AgreementRun(open_source(a), open_source(a), FIELD, (1, 540), [5.0])


# ---------------------------------------------------------------------------- real annotations


def copied(source: Path, target: Path, change: Change) -> Path:
    target.mkdir()
    for path in sorted(source.glob("*.json")):
        content = change(path.stem, json.loads(path.read_text()))
        if content is not None:
            (target / path.name).write_text(json.dumps(content))
    return target


def noisy(sigma_px: float) -> Change:
    rng = np.random.default_rng(5)

    def change(_name: str, content: dict[str, Any]) -> dict[str, Any]:
        for points in content.values():
            for point in points:
                point["x"] += rng.normal(0, sigma_px) / (SIZE[0] - 1)
                point["y"] += rng.normal(0, sigma_px) / (SIZE[1] - 1)
        return content

    return change


@pytest.fixture(scope="module", params=[6, pytest.param(1, marks=pytest.mark.soak)])
def real(shared_data, tmp_path_factory, request) -> Path:
    """Every sixth frame of the World Cup; all of them in `make soak`."""
    folder = tmp_path_factory.mktemp("real")
    for path in sorted((shared_data / "wc14" / "annotations").glob("*.json"))[:: request.param]:
        shutil.copy(path, folder)
    return folder


def count(folder: Path) -> int:
    return len(list(folder.iterdir()))


def test_an_annotator_agrees_with_himself(real) -> None:
    compared = run(real, real)
    results = list(compared)
    assert not [r for r in results if r.errors]
    found = summary(compared, results)
    clicked = [json.loads(path.read_text()) for path in real.iterdir()]
    assert found.frames == len(clicked)
    assert found.overall.common == sum(map(len, clicked))
    assert found.overall.points == 2 * sum(len(e) for frame in clicked for e in frame.values())
    assert (found.overall.apart, found.overall.left_out) == (0, 0)
    assert found.overall.largest == pytest.approx(0.0, abs=1e-9)
    assert found.mean_jac == {5.0: 1.0}
    assert found.mirrored == ()


@pytest.mark.parametrize("sigma", [0.5, 2.0])
def test_the_noise_of_a_copy_is_its_noise_floor(real, tmp_path, sigma) -> None:
    compared = run(real, copied(real, tmp_path / "b", noisy(sigma)))
    found = summary(compared, list(compared))
    # The absolute value of a normal variable: median 0.674 sigma, 95 % 1.96 sigma.
    assert found.overall.median == pytest.approx(0.674 * sigma, rel=0.05)
    assert found.overall.p95 == pytest.approx(1.96 * sigma, rel=0.05)
    assert found.overall.left_out < 0.01 * found.overall.points
    assert found.overall.apart == 0
    for name in ("Circle central", "Circle left", "Side line top"):
        assert found.per_class[name].median == pytest.approx(0.674 * sigma, rel=0.12)


def test_deleted_elements_and_files_are_counted(real, tmp_path) -> None:
    gone = tuple(sorted((path.stem for path in real.iterdir()), key=int)[:3])

    def change(name: str, content: dict[str, Any]) -> dict[str, Any] | None:
        content.pop("Side line top", None)
        return None if name in gone else content

    b = copied(real, tmp_path / "b", change)
    compared = run(real, b)
    found = summary(compared, list(compared))
    assert found.frames == count(real) - 3
    assert (found.frames_only_a, found.frames_only_b) == (gone, ())
    top = found.per_class["Side line top"]
    assert (top.common, top.only_b, top.median) == (0, 0, None)
    assert top.only_a == found.overall.only_a > 0.9 * count(real)
    assert found.overall.largest == pytest.approx(0.0, abs=1e-9)
    jac = found.mean_jac[5.0]
    assert jac is not None
    assert 0.8 < jac < 0.95
    back = run(b, real)
    assert summary(back, list(back)).overall.only_b == top.only_a


def test_swapped_labels_are_noticed_in_every_real_frame(real, tmp_path) -> None:
    def turned(_name: str, content: dict[str, Any]) -> dict[str, Any]:
        return {FIELD.symmetries[0].name_of(FIELD.canonical_name(k)): v for k, v in content.items()}

    compared = run(real, copied(real, tmp_path / "b", turned))
    assert len(summary(compared, list(compared)).mirrored) == count(real)
