"""The functions other programs call: what they read, fit and score, and how they decline."""

import ast
import inspect
import json
import re
import subprocess
import sys
import typing
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

import procc_annotator
from procc_annotator import (
    FrameAnnotation,
    HomographyCamera,
    ImageError,
    UsageError,
    camera_from_homography,
    check_labels,
    disagreement,
    draw_overlay,
    evaluate,
    evaluate_set,
    fit_camera,
    jac_curve,
    load_annotation,
    load_camera,
    project_field,
    propose_camera,
    track,
)
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import AnnotationError, ProccError
from procc_annotator.field.load import load_field
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup
from tests.drawn_shots import soccer_shot

SAMPLES = Path(__file__).parents[2] / "sample_data"
FRAME = SAMPLES / "00002.json"
CAMERA = SAMPLES / "cameras" / "bad" / "camera_00002.json"


def test_anything_but_one_readable_frame_is_declined(tmp_path):
    with pytest.raises(
        UsageError, match=r"holds \d+ frames \(00001, 00002, 00003, \.\.\.\), one is"
    ):
        load_annotation(SAMPLES)
    with pytest.raises(UsageError, match="no such file"):
        load_annotation(tmp_path / "nothing.json")
    damaged = tmp_path / "damaged.json"
    damaged.write_text('{"Middle line": [{"x": 0.5}]}')
    with pytest.raises(
        AnnotationError, match=r"damaged.json: Middle line\[0\]: the coordinate 'y'"
    ):
        load_annotation(damaged)
    (tmp_path / "empty").mkdir()
    with pytest.raises(UsageError, match="no annotation"):
        load_annotation(tmp_path / "empty")


def test_fit_and_score_with_nothing_but_the_annotation():
    annotation = load_annotation(FRAME)
    fit = fit_camera(annotation)
    assert fit.model == "R"
    assert evaluate(annotation, fit.camera).jac == 1.0
    few = fit_camera(FrameAnnotation(annotation.polylines[:2]))
    assert (few.camera, few.failure) == (None, "2 elements, 3 needed")
    with pytest.raises(UsageError, match="no camera to evaluate"):
        evaluate(annotation, few.camera)
    with pytest.raises(UsageError, match="did you mean auto"):
        fit_camera(annotation, model="auot")


def test_the_score_is_that_of_the_metric():
    annotation, field = load_annotation(FRAME), load_field()
    camera = PinholeCamera(
        0.0, np.deg2rad(77), 0.0, (0.0, 62.0, -17.0), (1480.0, 1480.0), (479.5, 269.5)
    )
    setup = EvaluationSetup(field, (960, 540), "procc")
    expected = score(measure(annotation, camera, setup), 8.0)
    found = evaluate(annotation, camera, threshold=8.0, protocol="procc")
    assert (found.jac, found.tp, found.fp, found.fn) == (
        expected.jac, expected.tp, expected.fp, expected.fn,
    )  # fmt: skip
    with pytest.raises(UsageError, match="unknown protocol"):
        evaluate(annotation, camera, protocol="soccer")


def test_labels_of_the_turned_field_count_where_they_are_allowed():
    annotation = load_annotation(FRAME)
    camera = fit_camera(annotation, model="P").camera
    x, y, z = camera.position_world
    turned = replace(camera, pan_rad=camera.pan_rad + np.pi, position_world=(-x, -y, z))
    assert evaluate(annotation, turned, protocol="procc").jac < 0.5
    found = evaluate(annotation, turned, protocol="procc", allow_mirrored=True)
    assert (found.jac, found.mirrored) == (1.0, True)
    assert evaluate(annotation, turned).mirrored  # as the official evaluation does anyway


def test_a_fit_brings_its_picture_size_along():
    annotation = load_annotation(FRAME)
    fit = fit_camera(annotation, size=(1920, 1080))
    alone = evaluate(annotation, fit_camera(annotation))
    assert evaluate(annotation, fit, threshold=10.0).jac == alone.jac == 1.0
    assert evaluate(annotation, fit).max_error == pytest.approx(2 * alone.max_error, rel=0.02)
    assert evaluate(annotation, fit, size=(960, 540)).max_error == pytest.approx(
        alone.max_error, rel=0.02
    )
    assert evaluate(annotation, fit.camera, size=(1920, 1080), threshold=10.0).jac == 1.0
    failed = fit_camera(FrameAnnotation(annotation.polylines[:2]))
    with pytest.raises(UsageError, match="the fit failed: 2 elements, 3 needed"):
        evaluate(annotation, failed)


@pytest.mark.parametrize("tau", [float("nan"), 0, -1, "5", None, float("inf"), True])
def test_a_threshold_is_a_positive_number(tau):
    annotation = load_annotation(FRAME)
    with pytest.raises(UsageError, match="threshold must be a positive number"):
        evaluate(annotation, fit_camera(annotation), threshold=tau)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"size": (960,)}, r"\(width, height\)"),
        ({"size": "960x540"}, r"\(width, height\) .* '960x540'"),
        ({"size": (float("nan"), 540)}, r"\(width, height\)"),
        ({"size": None}, r"\(width, height\)"),
        ({"model": None}, "unknown camera model None; choose one of H"),
        ({"field": {"length": 105}}, "expected a field, its name .* found dict"),
        ({"start": "x"}, "start: expected a camera .* found str"),
        ({"start": np.eye(3)}, "start: expected a camera .* found ndarray"),
        ({"annotation": {"Middle line": []}}, "expected an annotation .* found dict"),
        ({"annotation": str(FRAME)}, r"found str \(load_annotation\(path\) reads one\)"),
    ],
)
def test_arguments_that_are_none_are_declined(arguments, says):
    given = {"annotation": load_annotation(FRAME)} | arguments
    with pytest.raises(UsageError, match=says):
        fit_camera(**given)


def test_a_field_may_be_named():
    annotation = load_annotation(FRAME, "soccer")
    fit = fit_camera(annotation, "soccer")
    assert evaluate(annotation, fit, field="soccer").jac == 1.0
    with pytest.raises(ProccError, match="no such field"):
        fit_camera(annotation, "soccr")
    with pytest.raises(UsageError, match="camera: expected a camera"):
        evaluate(annotation, np.eye(3))


def test_a_camera_file_is_no_annotation(tmp_path):
    (tmp_path / "camera_1.json").write_text('{"pan_degrees": 1.0}')
    with pytest.raises(UsageError, match="is a camera file"):
        load_annotation(tmp_path / "camera_1.json")


def test_coordinates_in_pixels_are_told(tmp_path):
    content = {
        name: [{"x": 959 * p["x"], "y": 539 * p["y"]} for p in points]
        for name, points in json.loads(FRAME.read_text()).items()
    }
    (tmp_path / "1.json").write_text(json.dumps(content))
    with pytest.warns(UserWarning, match="look like pixels, expected 0 to 1"):
        annotation = load_annotation(tmp_path / "1.json")
    assert annotation.polylines[0].points[0].u == next(iter(content.values()))[0]["x"]
    for model in ("R", "auto", "H"):
        fit = fit_camera(annotation, model=model)
        assert fit.camera is None
        assert "look like pixels" in fit.failure


def test_a_camera_is_found_in_a_picture_and_followed():
    shot = soccer_shot(100, size=(640, 360))
    pictures = [shot.frame(n)[..., :3] for n in range(3)]
    followed: list[int] = []
    found = procc_annotator.track(
        pictures,
        "soccer",
        anchors={1: shot.cameras[1]},
        on_frame=lambda f: followed.append(f.number),
    )
    assert [frame.state for frame in found.frames] == ["followed", "anchor", "followed"]
    assert found.shots == ((0, 2),)
    assert set(followed) >= {0, 2}
    for frame, true in zip(found.frames, shot.cameras, strict=False):
        assert abs(frame.fit.camera.pan_rad - true.pan_rad) * true.focal_px[0] < 1.5
    proposal = procc_annotator.propose_camera(pictures[0])
    assert proposal.state in ("sure", "unsure")
    assert proposal.reason
    assert proposal.fit.size == (640, 360)


def test_pictures_that_are_none(tmp_path):
    for wrong in (np.zeros((4, 4)), np.zeros((4, 4, 3)), None, 7):
        with pytest.raises(UsageError, match="expected a picture"):
            procc_annotator.propose_camera(wrong)
    with pytest.raises(ProccError, match=r"no\.jpg"):
        procc_annotator.propose_camera(tmp_path / "no.jpg")
    with pytest.raises(ProccError, match=r"no\.mp4"):
        procc_annotator.track(tmp_path / "no.mp4")
    with pytest.raises(UsageError, match="video's path or a sequence"):
        procc_annotator.track(5)
    picture = np.zeros((90, 160, 3), np.uint8)
    with pytest.raises(UsageError, match=r"anchors\[0\]: expected a camera"):
        procc_annotator.track([picture], anchors={0: "camera"})
    for nowhere in (7, -1, "0"):
        with pytest.raises(UsageError, match=f"no frame {nowhere!r} among 1"):
            procc_annotator.track([picture], anchors={nowhere: HomographyCamera(np.eye(3))})
    assert procc_annotator.propose_camera(picture).state == "none"
    assert procc_annotator.track([]).frames == ()


@pytest.mark.parametrize("size", [(0, 540), (1, 540), (-5, 3), (960.5, 540), "x", (960, 540, 3)])
def test_a_size_is_whole_pixels_two_each_way(size):
    annotation, shown = load_annotation(FRAME), HomographyCamera(np.eye(3))
    camera = load_camera(CAMERA)
    for asked in (
        lambda: FrameAnnotation.from_dict({"Middle line": [(1, 2)]}, size=size),
        lambda: annotation.to_dict(size=size),
        lambda: evaluate(annotation, camera, size=size),
        lambda: evaluate(annotation, shown, camera_size=size),
        lambda: disagreement(camera, camera, size=size),
        lambda: camera_from_homography(np.eye(3), size=size),
    ):
        with pytest.raises(UsageError, match=r"size (as \(width, height\)|.* is too small)"):
            asked()


def test_a_class_is_given_once():
    points = [(0.1, 0.2), (0.3, 0.4)]
    with pytest.raises(UsageError, match="are the same class"):
        FrameAnnotation.from_dict({"Goal left post left": points, "Goal left post left ": points})


@pytest.mark.parametrize("shape", [(0, 0, 3), (0, 10, 4), (1, 1, 3)])
def test_a_picture_without_pixels_is_declined(shape):
    annotation, picture = load_annotation(FRAME), np.zeros(shape, np.uint8)
    for asked in (
        lambda: propose_camera(picture),
        lambda: draw_overlay(picture, annotation, load_camera(CAMERA)),
        lambda: check_labels(annotation, picture=picture),
        lambda: track([picture, picture]),
    ):
        with pytest.raises(UsageError, match=r"the picture of .* px is too small"):
            asked()


def test_the_class_of_a_camera_is_no_camera():
    class Mine:
        def project(self, points_world):
            return points_world[:, :2], np.ones(len(points_world), bool)

    with pytest.raises(UsageError, match="Mine is a class; give a camera made of it"):
        evaluate(load_annotation(FRAME), Mine)


@pytest.mark.parametrize("thresholds", [None, ["a"], [float("nan")]])
def test_the_thresholds_of_a_curve_are_numbers(thresholds):
    with pytest.raises(UsageError, match="expected thresholds as numbers of pixels"):
        jac_curve(load_annotation(FRAME), load_camera(CAMERA), thresholds)


def test_a_set_takes_one_threshold_or_several():
    given = {"1": load_annotation(FRAME)}, {"1": load_camera(CAMERA)}
    with pytest.raises(UsageError, match="a positive number of pixels, not None"):
        evaluate_set(*given, thresholds=None)
    assert list(evaluate_set(*given, thresholds=5).summaries) == [5.0]


# Overlay pictures as arrays, findings, and where a camera shows the field.


def test_an_overlay_is_a_picture(sample_data):
    picture = cv2.imread(str(sample_data / "00002.jpg"))
    annotation = load_annotation(sample_data / "00002.json")
    camera = load_camera(sample_data / "cameras" / "bad" / "camera_00002.json")
    plain = draw_overlay(picture)
    assert (plain.shape, plain.dtype) == (picture.shape, np.uint8)
    assert np.abs(plain.astype(int) - picture).max() < 3
    clicks = draw_overlay(sample_data / "00002.jpg", annotation)
    both = draw_overlay(picture, annotation, camera, caption="a method")
    changed = [(p != plain).any(axis=2).sum() for p in (clicks, both)]
    assert 0 < changed[0] < changed[1] < picture[..., 0].size
    half = draw_overlay(picture, annotation, camera, scale=0.5, painted_width=True)
    assert half.shape == (picture.shape[0] // 2, picture.shape[1] // 2, 3)


def test_a_camera_of_another_size_is_drawn_in_its_place(sample_data):
    picture = cv2.imread(str(sample_data / "00002.jpg"))
    height, width = picture.shape[:2]
    annotation = load_annotation(sample_data / "00002.json")
    small = fit_camera(annotation, size=(960, 540))
    assert small.size != (width, height)
    told = draw_overlay(picture, None, small)
    plain = draw_overlay(picture, None, small.camera, camera_size=(960, 540))
    assert (told == plain).all()
    assert (told != draw_overlay(picture, None, small.camera)).any()


def test_what_cannot_be_drawn(tmp_path):
    with pytest.raises(ImageError, match=r"no\.jpg"):
        draw_overlay(tmp_path / "no.jpg")
    with pytest.raises(UsageError, match="expected a picture"):
        draw_overlay(np.zeros((4, 4)))
    picture = np.zeros((90, 160, 3), np.uint8)
    with pytest.raises(UsageError, match="expected an annotation"):
        draw_overlay(picture, {"Middle line": []})
    with pytest.raises(UsageError, match="the scale must be"):
        draw_overlay(picture, scale=0)


def test_pieces_of_the_field_in_a_picture(sample_data):
    annotation = load_annotation(sample_data / "00002.json")
    fit = fit_camera(annotation)
    pieces = project_field(fit)
    shown = {
        e.name for e in evaluate(annotation, fit, protocol="procc").elements if e.status == "tp"
    }
    assert shown <= set(pieces)
    for parts in pieces.values():
        for points in parts:
            assert points.ndim == 2
            assert (points >= -1e-6).all()
            assert (points <= (959 + 1e-6, 539 + 1e-6)).all()


def test_mistakes_are_found(sample_data):
    annotation = load_annotation(sample_data / "00002.json")
    assert not [f for f in check_labels(annotation) if f.severity == "error"]
    lines = annotation.to_dict()
    first, second = [name for name, points in lines.items() if len(points) > 1][:2]
    lines[first], lines[second] = lines[second], lines[first]
    found = check_labels(FrameAnnotation.from_dict(lines), picture=sample_data / "00002.jpg")
    assert {first, second} & set(found[0].elements)
    assert found[0].severity == "error"
    assert found[0].reason


def test_nothing_of_it_needs_qt(sample_data):
    code = (
        "import sys\n"
        "for name in ('PySide6', 'pyqtgraph'): sys.modules[name] = None\n"
        "import procc_annotator as p\n"
        "for name in p.__all__: getattr(p, name)\n"
        f"a = p.load_annotation({str(sample_data / '00002.json')!r})\n"
        f"d = p.draw_overlay({str(sample_data / '00002.jpg')!r}, a, p.fit_camera(a))\n"
        "print(d.shape)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout.startswith("("), done.stderr


# What the package offers other programs: listed once, documented, typed, and nothing private.

PACKAGE = Path(procc_annotator.__file__).parent
PUBLIC = [name for name in procc_annotator.__all__ if name != "__version__"]
FUNCTIONS = [n for n in PUBLIC if inspect.isfunction(getattr(procc_annotator, n))]
CLASSES = [n for n in PUBLIC if inspect.isclass(getattr(procc_annotator, n))]


def test_every_name_is_there_and_none_else():
    assert sorted([*FUNCTIONS, *CLASSES]) == PUBLIC
    assert dir(procc_annotator) == sorted(procc_annotator.__all__)
    with pytest.raises(AttributeError, match="no attribute 'fit_cameras'"):
        procc_annotator.fit_cameras  # noqa: B018


def test_type_checkers_are_told_the_same_names_from_the_same_places():
    tree = ast.parse((PACKAGE / "__init__.py").read_text())
    block = next(node for node in tree.body if isinstance(node, ast.If))
    told = {
        alias.name: node.module
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert sorted(told) == PUBLIC
    for name, module in told.items():
        assert getattr(procc_annotator, name).__module__ == module, name


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_says_what_it_takes_gives_and_raises(name):
    function = getattr(procc_annotator, name)
    text = inspect.getdoc(function) or ""
    parts = re.split(r"^(Args|Returns|Raises):$", text, flags=re.M)
    sections = dict(zip(parts[1::2], parts[2::2], strict=True))
    parameters = inspect.signature(function).parameters
    for parameter in parameters:
        assert re.search(rf"(^|[ *,]){parameter}[:,]", sections["Args"], re.M), parameter
    if parameters:
        assert sections["Raises"].strip()
    assert "Returns" in sections or text.splitlines()[0].endswith("."), name


@pytest.mark.parametrize("name", CLASSES)
def test_a_class_says_what_it_holds(name):
    kind = getattr(procc_annotator, name)
    text = inspect.getdoc(kind) or ""
    assert text.strip(), name
    assert not text.startswith(f"{name}("), name  # what dataclasses write themselves
    for attribute, value in vars(kind).items():
        method = inspect.isfunction(value) or isinstance(value, property | classmethod)
        if not attribute.startswith("_") and method:
            told = inspect.getdoc(getattr(kind, attribute)) or inspect.getdoc(value)
            assert told, f"{name}.{attribute}"


def test_what_is_returned_is_public_itself():
    """Nobody has to import a private module to say what a function takes or gives."""
    for name in FUNCTIONS:
        for kind in _kinds(typing.get_type_hints(getattr(procc_annotator, name))):
            assert kind.__name__ in PUBLIC, f"{name}: {kind}"


def _kinds(hints: object) -> Iterator[type]:
    if isinstance(hints, dict):
        for hint in hints.values():
            yield from _kinds(hint)
    elif isinstance(hints, type) and hints.__module__.startswith("procc_annotator."):
        yield hints
    for inner in typing.get_args(hints):
        yield from _kinds(list(inner) if isinstance(inner, tuple) else inner)


def test_type_checkers_know_the_package():
    assert (PACKAGE / "py.typed").is_file()


def test_importing_the_package_is_next_to_nothing():
    """Two small modules of its own, and of the standard library what most programs load."""
    program = (
        "import sys; b = set(sys.modules); import procc_annotator; print(*set(sys.modules) - b)"
    )
    loaded = subprocess.run(
        [sys.executable, "-S", "-c", program],
        capture_output=True, text=True, check=True, cwd=PACKAGE.parent,
    ).stdout.split()  # fmt: skip
    own = {name for name in loaded if name.startswith("procc_annotator")}
    assert own == {"procc_annotator", "procc_annotator.version"}
    others = {name.partition(".")[0] for name in loaded} - {"procc_annotator"}
    assert others <= sys.stdlib_module_names
    assert not others & {"asyncio", "inspect", "email", "http", "json", "subprocess", "sqlite3"}
