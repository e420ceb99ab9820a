"""``procc-annotator check-submission`` as it is typed."""

from __future__ import annotations

import json
import zipfile

from typer.testing import CliRunner

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli.main import app
from procc_annotator.formats.cameras.soccernet import write_camera

CAMERA = PinholeCamera(0.1, 1.3, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (479.5, 269.5))


def test_a_good_and_an_incomplete_submission(tmp_path) -> None:
    path = tmp_path / "submission.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("valid/camera_1.json", write_camera(CAMERA))
    annotations = tmp_path / "annotations"
    annotations.mkdir()
    (annotations / "1.json").write_text("{}")
    run = CliRunner().invoke
    good = run(
        app, ["check-submission", str(path), "--annotations", str(annotations), "--split", "valid"]
    )
    assert (good.exit_code, good.stdout) == (
        0,
        "nothing to say: the official evaluation will read every camera\n",
    )
    (annotations / "2.json").write_text(json.dumps({}))
    missing = run(
        app, ["check-submission", str(path), "--annotations", str(annotations), "--split", "valid"]
    )
    assert missing.exit_code == 1
    assert missing.stdout.startswith("lowers the score: 1 of 2 annotated frames have no camera (2)")
    wrong = run(app, ["check-submission", str(path)])
    assert wrong.exit_code == 1
    assert "expected files named test/camera_FRAME.json" in wrong.stdout
    assert run(app, ["check-submission", str(tmp_path / "absent.zip")]).exit_code == 2
    folder = run(app, ["check-submission", str(annotations)])
    assert folder.exit_code == 2
    assert "is a folder, a submission is a zip archive" in folder.stderr
