"""What is said of many files with one problem, and of cameras of another sport."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.cli.echo import condense_problems


def test_the_same_problem_of_many_files_is_one_line() -> None:
    same = [f"/a/{i}.npy: expected 3 x 3 numbers (write it again)" for i in range(186)]
    other = ["/a/x.npy: is empty"]
    lines = ["/a/0.npy and 185 more: expected 3 x 3 numbers (write it again)", *other]
    assert condense_problems([*same, *other]) == lines


def test_the_same_problem_of_many_places_is_one_line() -> None:
    same = [f"/a.mat: annotation({i}): is of another sport" for i in range(1, 9)]
    assert condense_problems(same) == ["/a.mat: annotation(1) and 7 more: is of another sport"]


def test_frames_of_a_video_with_the_same_problem_are_counted_and_named_in_one_line() -> None:
    some = [f"/a.mp4: frame {n}: damaged" for n in (20, 21, 22, 40)]
    other = ["/a.mp4: frame 7: its size changes", "/b.mp4: frame 1: damaged"]
    assert condense_problems([*some, *other]) == [
        "/a.mp4: 4 frames (20 to 22, 40): damaged",
        *other,
    ]


def test_different_problems_and_few_of_them_stay_as_they_are() -> None:
    few = [f"/a/{i}.npy: is empty" for i in range(5)]
    different = [f"/a.json: holds {i} numbers (expected: 9)" for i in range(9)]
    assert condense_problems([*few, *different]) == [*few, *different]


@pytest.mark.parametrize("command", ["export", "render", "compare", "report", "evaluate"])
def test_a_bare_homography_is_not_taken_for_one_of_another_sport(
    cli, dataset, tmp_path, command
) -> None:
    bare = tmp_path / "bare"
    bare.mkdir()
    for frame in ("1", "2", "3", "10", "11"):
        np.save(bare / f"{frame}.npy", np.diag([0.1, 0.1, 1.0]))
    root, out = dataset.root, tmp_path / "out"
    arguments = {
        "export": (root, out, "--cameras", bare),
        "render": (root, out, "--cameras", bare),
        "compare": (bare, dataset.cameras, root),
        "report": (root, "--cameras", f"bare={bare}", "-o", tmp_path / "report.json"),
        "evaluate": (dataset.annotations, bare),
    }
    done = cli(command, *arguments[command], "--field", "futsal")
    assert done.exit_code in (1, 2)
    assert "nothing says which ground it is of" in done.stderr
    assert "this is Futsal" in done.stderr
    assert "choose its camera format" in done.stderr


def test_a_damaged_file_of_many_cameras_is_told_by_itself(cli, dataset, tmp_path) -> None:
    for name, content in (
        ("cut.mat", b"MATLAB 5.0 MAT-file" + bytes(99)),
        ("cut.json", b'{"1": {'),
    ):
        (tmp_path / name).write_bytes(content)
        done = cli("evaluate", dataset.annotations, tmp_path / name)
        assert done.exit_code == 2
        assert done.stderr.startswith(f"procc-annotator: {tmp_path / name}: ")
        assert len(done.stderr.splitlines()) == 1
