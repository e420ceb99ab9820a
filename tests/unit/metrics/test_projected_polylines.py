"""Sources that give projected polylines: judged exactly as the camera that drew them would be."""

import json

import numpy as np
import pytest

from procc_annotator.batch.audit import audit_frame
from procc_annotator.camera.base import ElementProjections
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.metrics.measurement import measure, nearest_points
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field()
SIZE = (960, 540)
SETUPS = {p: EvaluationSetup(FIELD, SIZE, p) for p in ("soccernet", "procc")}


def given(**pieces: list[list[tuple[float, float]]]) -> ElementProjections:
    return ElementProjections(
        {
            name.replace("_", " "): tuple(np.array(p, dtype=float) for p in some)
            for name, some in pieces.items()
        }
    )


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
def test_the_polylines_of_a_camera_score_as_the_camera_does(protocol, sample_data):
    setup = SETUPS[protocol]
    compared = 0
    for file in sorted(sample_data.glob("*.json")):
        path = sample_data / "cameras" / "pinhole" / f"camera_{file.stem}.json"
        if not path.exists():
            continue
        annotation = read_annotation(file.read_bytes(), path=str(file), field=FIELD)
        camera = read_camera_file(path.read_bytes(), path=str(path)).camera
        drawn = project_field(camera, setup)
        shared = json.dumps(
            {
                name: [
                    [{"x": x / 959, "y": y / 539} for x, y in piece.tolist()]
                    for piece in drawn.measured.pieces_of(row)
                ]
                for row, name in enumerate(drawn.names)
            }
        )
        loaded = read_camera_file(shared.encode(), path="1.json", fmt="polylines")
        projections, _ = fit_to_size(loaded, SIZE)
        own, theirs = (measure(annotation, c, setup) for c in (camera, projections))
        for tau in (2.0, 5.0, 10.0):
            a, b = score(own, tau), score(theirs, tau)
            assert (a.tp, a.fp, a.fn, a.mirrored) == (b.tp, b.fp, b.fn, b.mirrored)
        np.testing.assert_allclose(theirs.plain.all_distances, own.plain.all_distances, atol=1e-9)
        assert len(nearest_points(theirs, theirs.plain)) == len(theirs.plain.names)
        audit = audit_frame(file.stem, projections, "projections", theirs, 5.0)
        assert audit.pose is None
        compared += 1
    assert compared >= 3


def test_unclipped_samples_are_clipped_as_each_protocol_does():
    camera = given(Middle_line=[[(-100.0, 100.0), (100.0, 100.0), (1100.0, 100.0)]])
    official = project_field(camera, SETUPS["soccernet"]).pieces["Middle line"]
    fine = project_field(camera, SETUPS["procc"]).pieces["Middle line"]
    assert [p.tolist() for p in official] == [[[0, 100], [100, 100], [959, 100]]]
    assert [p.tolist() for p in fine] == [[[0, 100], [100, 100], [959, 100]]]
    assert not project_field(camera, SETUPS["procc"]).left_out
    # Without a vertex inside, the official evaluation sees nothing; the paper's definition does.
    crossing = given(Middle_line=[[(-100.0, 100.0), (1100.0, 100.0)]])
    assert not project_field(crossing, SETUPS["soccernet"]).pieces
    assert project_field(crossing, SETUPS["procc"]).pieces["Middle line"][0].tolist() == [
        [0, 100],
        [959, 100],
    ]


def test_pieces_are_never_joined_and_circles_stay_as_they_are():
    circle = [(100.0, 100.0), (200.0, 100.0), (150.0, 180.0), (100.0, 100.0)]
    camera = given(
        Side_line_top=[[(10.0, 10.0), (20.0, 10.0)], [(300.0, 10.0), (400.0, 10.0)]],
        Circle_central=[circle],
        Nowhere=[[(1.0, 1.0), (2.0, 2.0)]],
    )
    for setup in SETUPS.values():
        pieces = project_field(camera, setup).pieces
        assert set(pieces) == {"Side line top", "Circle central"}
        assert len(pieces["Side line top"]) == 2
        assert pieces["Circle central"][0].tolist() == [list(p) for p in circle]
        annotation = read_annotation(
            b'{"Side line top": [{"x": 0.1668, "y": 0.01855}]}', path="a.json", field=FIELD
        )
        (distance,) = measure(annotation, camera, setup).plain.all_distances
        assert distance == pytest.approx(140, abs=0.2)  # to an end, not to a line across the gap


def test_repeated_and_single_vertices():
    repeated = given(Middle_line=[[(10.0, 10.0), (10.0, 10.0), (20.0, 10.0)]])
    annotation = read_annotation(
        json.dumps({"Middle line": [{"x": 15 / 959, "y": 12 / 539}]}).encode(),
        path="a.json",
        field=FIELD,
    )
    for setup in SETUPS.values():
        assert measure(annotation, repeated, setup).plain.all_distances == pytest.approx([2.0])
    alone = given(Middle_line=[[(15.0, 10.0)]])
    assert measure(annotation, alone, SETUPS["soccernet"]).plain.all_distances == pytest.approx(
        [2.0]
    )
    assert not project_field(alone, SETUPS["procc"]).pieces
    for setup in SETUPS.values():
        assert not project_field(ElementProjections({}), setup).pieces
        assert not project_field(given(Middle_line=[]), setup).pieces


def test_a_class_without_its_trailing_space_is_the_class():
    camera = ElementProjections({"Goal left post left": (np.array([[1.0, 1], [5, 5]]),)})
    assert list(project_field(camera, SETUPS["procc"]).pieces) == ["Goal left post left "]


def test_a_whole_camera_and_its_projections_agree_on_every_official_sample():
    """Handing over unclipped official samples gives the same visible polylines."""
    setup = SETUPS["soccernet"]
    camera = PinholeCamera(0.1, 1.35, 0.0, (2.0, 60.0, -15.0), (600.0, 600.0), (479.5, 269.5))
    px, valid = camera.project(setup.tables.points_world)
    rows = setup.tables.element_of_sample
    pieces = {name: (px[(rows == row) & valid],) for row, name in enumerate(setup.tables.names)}
    theirs = project_field(ElementProjections(pieces), setup).pieces
    own = project_field(camera, setup).pieces
    assert theirs.keys() == own.keys()
    assert len(own) > 8
    for name in own:
        np.testing.assert_allclose(theirs[name][0], own[name][0], atol=2e-4)  # single precision
