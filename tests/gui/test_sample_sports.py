"""The samples of other sports open as what they are: the right field, cameras that fit it."""

import shutil
from collections.abc import Callable

import pytest

from procc_annotator.gui.main_window import MainWindow

MakeWindow = Callable[..., MainWindow]


@pytest.mark.parametrize(
    ("folder", "field", "element"),
    [
        ("basketball", "basketball_fiba", "Rim left"),
        ("volleyball", "volleyball", "Net top band"),
        ("ice_hockey", "ice_hockey_iihf", "Line blue left"),
    ],
)
def test_a_sample_opens_with_its_field(
    make_window, qtbot, sample_data, tmp_path, folder, field, element
):
    dataset = tmp_path / folder
    (dataset / "cameras").mkdir(parents=True)
    for name in ("field.toml", "00001.jpg", "00001.json"):
        shutil.copy(sample_data / folder / name, dataset)
    for source in ("true", "late"):
        shutil.copytree(sample_data / folder / "cameras" / source, dataset / "cameras" / source)
    window = make_window(dataset)
    services = window.services
    assert services.state.field.name == field
    assert services.state.annotation.get(element) is not None
    services.camera_sources.load_cameras(dataset / "cameras" / "true")
    qtbot.waitUntil(lambda: services.scorer.score is not None)
    assert services.scorer.score.jac == 1.0
    services.camera_sources.load_cameras(dataset / "cameras" / "late")
    qtbot.waitUntil(lambda: services.state.active.name == "late")
    assert services.scorer.score.jac < 0.5
