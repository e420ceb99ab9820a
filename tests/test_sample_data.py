"""The samples are drawn from known cameras, the same on every run, and hold every overlay state."""

import importlib.util
import json
import re
import sys
from pathlib import Path
from types import ModuleType

import cv2
import numpy as np
import pytest

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.dataset_field import field_of_dataset
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.geometry import Line
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Element
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

GOLDEN = Path(__file__).with_name("unit") / "golden_sample_scores.json"


@pytest.fixture(scope="module")
def maker(sample_data) -> ModuleType:
    """The drawing script as a module."""
    spec = importlib.util.spec_from_file_location(
        "make_sample_data", sample_data / "make_sample_data.py"
    )
    module = importlib.util.module_from_spec(spec)
    before = list(sys.path)
    spec.loader.exec_module(module)
    sys.path[:] = before
    return module


SOCCER = "soccer"
INDOORS = ("basketball_fiba", "volleyball", "ice_hockey_iihf")
SPORTS = (SOCCER, *INDOORS)


def test_all_sports_are_there(maker):
    assert tuple(maker.SPORTS) == SPORTS


@pytest.mark.parametrize("name", SPORTS)
def test_it_is_small_and_looks_like_a_dataset(maker, sample_data, name):
    sport = maker.SPORTS[name]
    folder = sample_data / sport.folder
    pictures = sorted(folder.glob("*.jpg"))
    assert [p.stem for p in pictures] == [view.name for view in sport.views]
    assert len(pictures) >= 5
    for picture in pictures:
        assert cv2.imread(str(picture)).shape == (720, 1280, 3)
        assert picture.stat().st_size < 250e3
    annotated = {p.stem for p in folder.glob("*.json")}
    assert 1 <= len(pictures) - len(annotated) <= 4
    assert {p.name for p in (folder / "cameras").iterdir()} == set(sport.sets)


def test_all_of_them_together_are_small(sample_data):
    files = [p for p in sample_data.rglob("*") if p.is_file() and "__pycache__" not in p.parts]
    assert sum(p.stat().st_size for p in files) < 6e6


@pytest.mark.parametrize("name", SPORTS)
def test_a_dataset_says_which_field_it_shows(maker, sample_data, name):
    found = field_of_dataset(sample_data / maker.SPORTS[name].folder)
    assert found.field.name == name
    assert found.field.elements == load_field(name).elements
    assert found.chosen == (name != SOCCER)


@pytest.mark.parametrize("name", SPORTS)
def test_drawing_again_gives_the_same(maker, sample_data, tmp_path, name):
    sport = maker.SPORTS[name]
    maker.write_field(sport, tmp_path)
    for view in sport.views:
        maker.write_data(sport, view, tmp_path)
    drawn = sorted(p.relative_to(tmp_path) for p in tmp_path.rglob("*") if p.is_file())
    assert len(drawn) > 20
    for file in drawn:
        made, stored = tmp_path / file, sample_data / sport.folder / file
        if file.suffix == ".homographyMatrix":
            yards = [shown_yards(np.loadtxt(path)) for path in (made, stored)]
            assert yards[0] == pytest.approx(yards[1], abs=1e-4), file
        elif file.suffix == ".json":
            numbers, texts = zip(*map(split_numbers, (made, stored)), strict=True)
            assert texts[0] == texts[1], file
            assert numbers[0] == pytest.approx(numbers[1], abs=2e-5), file
        else:
            assert made.read_bytes() == stored.read_bytes(), file


# What is computed differs in its last bits from processor to processor, and where such a bit
# decides, in the last digit that is written: a hundredth of a pixel of a click, less of a camera.
def split_numbers(path: Path) -> tuple[list[float], str]:
    """The numbers of a file, in order, and what stands between them."""
    number, text = r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?", path.read_text()
    return [float(n) for n in re.findall(number, text)], re.sub(number, "#", text)


def shown_yards(yards_from_image: np.ndarray) -> np.ndarray:
    """(12, 2) yards: where a homography of the field puts places of the picture's lower half."""
    px = [(x, y, 1.0) for x in (0.0, 426.0, 853.0, 1279.0) for y in (360.0, 540.0, 719.0)]
    shown = np.array(px) @ yards_from_image.T
    return np.asarray(shown[:, :2] / shown[:, 2:])


@pytest.mark.parametrize(
    ("name", "number"), [(SOCCER, 10), pytest.param("volleyball", 3, marks=pytest.mark.soak)]
)
def test_a_picture_drawn_again_is_the_same_picture(maker, sample_data, name, number):
    sport = maker.SPORTS[name]
    view = sport.views[number]
    stored = cv2.imread(str(sample_data / sport.folder / f"{view.name}.jpg")).astype(float)
    assert np.abs(maker.draw(sport, view).astype(float) - stored).mean() < 3.0


@pytest.mark.parametrize("name", SPORTS)
def test_golden_scores(maker, name):
    golden = json.loads(GOLDEN.read_text())[name]
    found = maker.scores(maker.SPORTS[name])
    assert found.keys() == golden.keys()
    for source, protocols in golden.items():
        for protocol, by_threshold in protocols.items():
            assert found[source][protocol] == pytest.approx(by_threshold, abs=1e-6)


@pytest.mark.parametrize("name", INDOORS)
def test_every_camera_set_has_a_fault_of_its_own(maker, name):
    golden = json.loads(GOLDEN.read_text())[name]
    found = {source: protocols["procc"] for source, protocols in golden.items()}
    assert found["true"]["2"] == 1.0
    # The lens that is not known costs a few pixels, a lag or a poor guess more; on the other side
    # every label is wrong that has a partner, whatever the threshold, but for those who mirror it.
    assert found["pinhole"]["2"] < 0.9 < found["pinhole"]["5"]
    for source in ("bad", "late"):
        assert found[source]["2"] < 0.3 < 0.6 < found[source]["10"] < 1.0
    assert found["turned"]["10"] == found["turned"]["2"] < 0.2
    assert golden["turned"]["soccernet"]["10"] > 0.95


@pytest.mark.parametrize("name", SPORTS)
def test_the_true_cameras_are_right_and_the_bad_ones_show_every_state(maker, sample_data, name):
    sport = maker.SPORTS[name]
    folder, field = sample_data / sport.folder, sport.field
    workspace = Workspace.open(folder, field)
    states: dict[str, set[str]] = {source: set() for source in ("true", "bad")}
    if name == SOCCER:
        states["homography"] = set()
    for source, seen in states.items():
        cameras = CameraSet.open(folder / "cameras" / source)
        for index, frame in enumerate(workspace.frames):
            camera = cameras.camera(frame.name, (960, 540))
            if camera is not None:
                measured = measure(workspace.read(index), camera.camera, EvaluationSetup(field))
                seen |= {e.status for e in score(measured, 5.0).elements}
                if source == "true" and name == SOCCER and workspace.annotated_count(index):
                    assert score(measured, 5.0).jac == 1.0
    assert states["bad"] >= {"tp", "too_far", "not_annotated"}
    bad = CameraSet.open(folder / "cameras" / "bad")
    assert len(workspace.frames) - len(bad.frames) == (3 if name == SOCCER else 1)
    if name == SOCCER:
        assert "missed" in states["homography"]


def test_lines_are_where_the_true_camera_puts_them(maker, sample_data):
    """White paint lies on the projected halfway line, grass beside it."""
    view = maker.SPORTS[SOCCER].views[0]
    picture = cv2.imread(str(sample_data / f"{view.name}.jpg")).astype(float)
    points = np.array([[0.0, y, 0.0] for y in np.linspace(12, 30, 40)])
    px, _ = view.picture_camera.project(points)
    inside = px[:, 1] < 715
    on = np.array([picture[round(y), round(x)].min() for x, y in px[inside]])
    beside = np.array([picture[round(y), round(x) + 9].min() for x, y in px[inside]])
    assert np.median(on) > 150
    assert np.median(beside) < 100


def _middle_of_paint(element: Element, places: np.ndarray) -> np.ndarray:
    """(n, 3) metres: places of an element moved to the middle of its paint."""
    if element.inside is None:
        return places
    inside = np.array(element.inside)
    if isinstance(element.geometry, Line):
        along = places[-1] - places[0]
        normal = np.array([-along[1], along[0], 0.0]) / np.linalg.norm(along)
        normal *= np.sign((inside - places[0]) @ normal)
    else:  # round, measured at its outer edge
        normal = (inside - places) / np.linalg.norm(inside - places, axis=1, keepdims=True)
    return np.asarray(places + normal * element.line_width / 2)


@pytest.mark.parametrize("name", SPORTS)
def test_every_frame_is_painted_where_its_true_camera_says(maker, sample_data, name):
    """Across each ground line the paint's middle lies on the projection, distortion included."""
    sport = maker.SPORTS[name]
    samples = sample_evenly(sport.field, 0.25)
    across = np.arange(-9, 9.01, 0.25)
    one_side, other_side = across < -4, across > 4
    for view in sport.views:
        picture = cv2.imread(str(sample_data / sport.folder / f"{view.name}.jpg"))
        # Lines are white on the ground, or dark on white ice.
        dark = name == "ice_hockey_iihf"
        values = (255 - picture if dark else picture).astype(np.float32)
        values = values.max(axis=2) if dark else values.min(axis=2)
        offsets = []
        for i, element in enumerate(sport.field.elements):
            painted = element.name not in sport.absent
            if name != SOCCER:
                painted &= element.line_width > 0
            if not (element.on_ground and painted) or element.is_spot:
                continue
            if len(getattr(element.geometry, "parts", ())) > 0:
                continue  # a chain is two lines and an arc; those are looked at elsewhere
            places = samples.of(i)
            if name != SOCCER:
                places = _middle_of_paint(element, places)
            px, in_front = view.picture_camera.project(places)
            along = np.gradient(px, axis=0)
            seen = in_front & (px > 12).all(axis=1)
            seen &= (px < np.array([1267, 707])).all(axis=1)
            seen &= np.linalg.norm(along, axis=1) > 0
            along = along[seen] / np.linalg.norm(along[seen], axis=1, keepdims=True)
            normal = along[:, ::-1] * (1, -1)
            at = (px[seen][:, None] + across[:, None] * normal[:, None]).astype(np.float32)
            if len(at) < 4:
                continue
            profile = cv2.remap(values, at[..., 0], at[..., 1], cv2.INTER_LINEAR)
            paint = np.clip(profile - np.median(profile, axis=1, keepdims=True) - 12, 0, None)
            sides = (
                np.median(profile[:, one_side], axis=1),
                np.median(profile[:, other_side], axis=1),
            )
            # Where a coloured area ends at the line the paint has no middle of its own.
            clear = (paint.max(axis=1) > 25) & (np.abs(sides[0] - sides[1]) < 12)
            middle = (paint[clear] * across).sum(axis=1) / paint[clear].sum(axis=1)
            if clear.sum() >= 4:
                offsets.append(abs(np.median(middle)))
        assert len(offsets) >= 2, view.name
        # Players stand on some lines and faint ones are lost: most lines decide, not all.
        assert np.median(offsets) < 0.1, view.name


def test_the_rim_hangs_in_the_air_where_the_true_camera_puts_it(maker, sample_data):
    """Orange is seen all around the projected ring, a hand's breadth higher it is not."""
    sport = maker.SPORTS["basketball_fiba"]
    for number, rim in ((1, "Rim left"), (2, "Rim right"), (3, "Rim right")):
        view = sport.views[number]
        picture = cv2.imread(str(sample_data / sport.folder / f"{view.name}.jpg")).astype(
            np.float32
        )
        orange = picture[..., 2] - picture[..., 0]
        ring = sample_evenly(sport.field, 0.02).of(sport.field.index[rim])
        seen = []
        for up in (0.0, 0.12):
            px = view.picture_camera.project(ring - (0, 0, up))[0].astype(np.float32)
            seen.append(np.median(cv2.remap(orange, px[:, :1], px[:, 1:], cv2.INTER_LINEAR)))
        assert seen[0] > 40 > 15 > seen[1], view.name


def test_no_false_line_runs_through_the_grass(maker, sample_data):
    """The noise repeats without a seam: along the pitch's axis nothing looks painted."""
    view = maker.SPORTS[SOCCER].views[8]
    picture = cv2.imread(str(sample_data / f"{view.name}.jpg")).astype(np.float32).mean(axis=2)
    x = np.linspace(-46.5, -41.8, 160)  # from the goal area to the penalty mark

    def brightness(y: float) -> float:
        px, _ = view.picture_camera.project(np.column_stack([x, np.full_like(x, y), 0 * x]))
        at = px.astype(np.float32)
        return float(cv2.remap(picture, at[:, :1], at[:, 1:], cv2.INTER_LINEAR).mean())

    assert abs(brightness(0.12) - brightness(-0.12)) < 3.0


def test_it_draws_into_a_new_folder(maker, tmp_path, monkeypatch):
    monkeypatch.setattr(maker, "draw", lambda *_: np.zeros((720, 1280, 3), np.uint8))
    folder = tmp_path / "a" / "b"
    arguments = [
        "--out",
        str(folder),
        "--sport",
        SOCCER,
        "--sport",
        "volleyball",
        "--frame",
        "00001",
    ]
    monkeypatch.setattr(sys, "argv", ["make_sample_data.py", *arguments])
    maker.main()
    assert (folder / "00001.jpg").is_file()
    assert (folder / "cameras" / "bad" / "camera_00001.json").is_file()
    assert not (folder / "field.toml").exists()
    assert (folder / "volleyball" / "00001.jpg").is_file()
    assert (folder / "volleyball" / "field.toml").is_file()
    assert not (folder / "volleyball" / "00002.jpg").exists()
