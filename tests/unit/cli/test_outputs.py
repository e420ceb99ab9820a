"""Where commands may write: checks that they share."""

from pathlib import Path

import pytest

from procc_annotator.cli.outputs import check_camera_folder, check_not_inputs
from procc_annotator.errors import UsageError
from procc_annotator.formats.file_source import open_source

LINE = '{"Middle line": [{"x": 0.5, "y": 0.4}, {"x": 0.5, "y": 0.6}]}'


@pytest.fixture
def annotations(tmp_path) -> Path:
    folder = tmp_path / "annotations"
    folder.mkdir()
    (folder / "1.json").write_text(LINE)
    return folder


def test_cameras_go_to_a_folder_apart_from_what_is_read(annotations, tmp_path):
    pictures, file = tmp_path / "pictures", tmp_path / "file"
    pictures.mkdir()
    file.write_text("")
    check_camera_folder(tmp_path / "new", [annotations, None, file])
    check_camera_folder(pictures, [annotations, None])
    for out, inputs, says in (
        (tmp_path / "out.zip", [], "a folder is needed"),
        (file, [], "a folder is needed"),
        (pictures, [pictures], "holds the files to be read"),
        (annotations, [pictures], r"holds annotations \(1.json\)"),
    ):
        with pytest.raises(UsageError, match=says):
            check_camera_folder(out, inputs)


def test_no_file_replaces_an_input_under_whatever_name(annotations, tmp_path):
    other, linked = tmp_path / "other.json", tmp_path / "linked.csv"
    linked.hardlink_to(annotations / "1.json")
    with open_source(annotations) as source:
        check_not_inputs([other, annotations / "new.csv"], [source, tmp_path / "gone"])
        for path, says in (
            (annotations / "1.json", "is one of the files to be read"),
            (linked, "is one of the files to be read"),
            (annotations / "new.json", "holds the files to be read"),
        ):
            with pytest.raises(UsageError, match=says):
                check_not_inputs([other, path], [source])
