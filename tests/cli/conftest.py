"""A small dataset: five frames seen by known cameras, annotated where those show the field."""

import csv
import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, ClassVar

import cv2
import numpy as np
import pytest
from typer.main import get_command
from typer.testing import CliRunner, Result

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli.main import app
from procc_annotator.field.load import load_field
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
PANS = {"1": -35.0, "2": -20.0, "3": 0.0, "10": 20.0, "11": 35.0}


@pytest.fixture(scope="module", autouse=True)
def wide_tables() -> Iterator[None]:
    """Whoever runs the tests may have set how wide tables are; workers of pytest-xdist do."""
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("COLUMNS", raising=False)
        yield


def camera_file(pan: float, **changes: Any) -> dict[str, Any]:
    """The content of a SoccerNet camera file of a main camera."""
    return {
        "pan_degrees": pan,
        "tilt_degrees": 78.0,
        "roll_degrees": 0.0,
        "position_meters": [0.0, 60.0, -14.0],
        "x_focal_length": 1400.0,
        "y_focal_length": 1400.0,
        "principal_point": [479.5, 269.5],
        "radial_distortion": [0.0] * 6,
        "tangential_distortion": [0.0] * 2,
        "thin_prism_distortion": [0.0] * 4,
    } | changes


@cache
def annotation_text(pan: float, size: tuple[int, int] = SIZE) -> str:
    return json.dumps(annotation_file(pan, size))


def annotation_file(pan: float, size: tuple[int, int] = SIZE) -> dict[str, list[dict[str, float]]]:
    """Three points on every element that such a camera shows, exact."""
    centre = ((size[0] - 1) / 2, (size[1] - 1) / 2)
    camera = PinholeCamera(
        np.deg2rad(pan), np.deg2rad(78.0), 0.0, (0.0, 60.0, -14.0), (1400.0, 1400.0), centre
    )
    projected = project_field(camera, EvaluationSetup(load_field("soccer"), size))
    return {
        name: [
            {"x": float(x) / (size[0] - 1), "y": float(y) / (size[1] - 1)}
            for x, y in pieces[0][[0, len(pieces[0]) // 2, -1]]
        ]
        for name, pieces in projected.pieces.items()
    }


@dataclass(frozen=True)
class Dataset:
    root: Path
    pans: ClassVar = PANS

    @property
    def annotations(self) -> Path:
        return self.root / "annotations"

    @property
    def cameras(self) -> Path:
        return self.root / "cameras"

    @property
    def set_arguments(self) -> list[str]:
        return [str(self.annotations), str(self.cameras)]

    def write_frame(self, name: str, pan: float, size: tuple[int, int]) -> None:
        """A picture of this size and what its camera shows, without the camera."""
        cv2.imwrite(str(self.root / f"{name}.jpg"), np.zeros((size[1], size[0], 3), np.uint8))
        (self.annotations / f"{name}.json").write_text(annotation_text(pan, size))

    def write_camera(self, name: str, content: object) -> Path:
        path = self.cameras / f"camera_{name}.json"
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path


@cache
def grey_picture() -> bytes:
    _, encoded = cv2.imencode(".jpg", np.full((SIZE[1], SIZE[0], 3), 90, dtype=np.uint8))
    return encoded.tobytes()


def write_dataset(root: Path) -> Dataset:
    made = Dataset(root)
    made.annotations.mkdir(parents=True)
    made.cameras.mkdir()
    for name, pan in PANS.items():
        (made.root / f"{name}.jpg").write_bytes(grey_picture())
        (made.annotations / f"{name}.json").write_text(annotation_text(pan))
        made.write_camera(name, camera_file(pan))
    return made


@pytest.fixture
def dataset(tmp_path) -> Dataset:
    return write_dataset(tmp_path / "match")


@pytest.fixture(scope="module")
def new_dataset(tmp_path_factory) -> Callable[[], Dataset]:
    """Makes a dataset for several tests of a module, none of which changes it."""
    return lambda: write_dataset(tmp_path_factory.mktemp("shared") / "match")


class Cli:
    """Runs the command in this process; it must exit with this code (None: any)."""

    def __call__(self, *arguments: object, code: int | None = 0) -> Result:
        done = CliRunner().invoke(app, [str(a) for a in arguments])
        if done.exception is not None and not isinstance(done.exception, SystemExit):
            raise done.exception
        assert code in (None, done.exit_code), done.output
        return done


def rows_in(path: Path) -> list[dict[str, str]]:
    """The rows of a CSV file."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@cache
def command() -> Any:
    return get_command(app)


@pytest.fixture(scope="module")
def cli() -> Iterator[Cli]:
    with pytest.MonkeyPatch.context() as patch:
        # The commands' signatures are looked through once, not for every call.
        patch.setattr("typer.testing._get_command", lambda _: command())
        yield Cli()


@pytest.fixture
def no_charts(monkeypatch) -> None:
    """Pages without charts, which take longer than all the rest: for tests of what else is told."""
    monkeypatch.setattr("procc_annotator.report.page.report.draw_charts", lambda *_: [])
