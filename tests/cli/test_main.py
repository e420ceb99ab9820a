"""The command itself: version, help, what a bare path does, errors."""

import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from functools import partial
from pathlib import Path

import pytest
import typer

from procc_annotator import __version__
from procc_annotator.cli import console
from procc_annotator.cli.main import app

COMMANDS = ("open", "evaluate", "export", "render")


def run(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "procc_annotator", *arguments],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **environment},
    )


def test_version(cli):
    assert cli("--version").stdout.strip() == f"procc-annotator {__version__}"


def test_help_lists_the_commands_and_shows_examples(cli):
    text = cli("--help").stdout
    assert all(f"  {name} " in text for name in COMMANDS)
    assert "Examples:" in text


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_with_an_example(cli, name):
    done = cli(name, "--help")
    example = done.stdout.split("Examples:")[1]
    assert f"procc-annotator {name} " in example
    options = typer.main.get_command(app).commands[name].load().params
    assert [option.name for option in options if not option.help] == []


def test_a_mistyped_command_is_recognised(cli):
    done = cli("evalute", "a", "b", code=2)
    assert "evaluate" in done.stderr


@pytest.mark.parametrize("arguments", [[], ["open"], ["."], ["--cameras", "."]])
def test_without_a_display_the_window_says_so(arguments):
    done = run(*arguments, DISPLAY="", WAYLAND_DISPLAY="", QT_QPA_PLATFORM="")
    if not sys.platform.startswith("linux"):
        pytest.skip("other systems always have a display")
    assert done.returncode == 2
    assert done.stderr.startswith("procc-annotator: there is no display")
    assert len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize("command", [[], ["open"]])
def test_a_path_opens_the_window(cli, qapp, monkeypatch, tmp_path, command):
    from procc_annotator.gui import app as gui_app

    opened, fields = [], []

    def main(path, *, annotations, cameras, field) -> int:
        opened.append((path, cameras))
        fields.append(None if field is None else field.name)
        return 0

    monkeypatch.setattr(gui_app, "main", main)
    cli(*command, tmp_path)
    cli(*command, "--cameras", tmp_path)
    both = ["--cameras", f"ours={tmp_path}", "--cameras", f"theirs:carwc={tmp_path}"]
    cli(*command, tmp_path, *both)
    choice = gui_app.CameraChoice
    assert opened == [
        (tmp_path, []),
        (None, [choice(tmp_path)]),
        (tmp_path, [choice(tmp_path, name="ours"), choice(tmp_path, "carwc", "theirs")]),
    ]
    assert fields == [None, None, None]  # the dataset's own
    cli(*command, "--cameras", f"ours={tmp_path / 'nowhere'}", code=2)
    cli("open", tmp_path, "--field", "tennis")
    assert fields[3:] == ["tennis"]


def test_a_path_that_does_not_exist_is_one_line(cli):
    done = cli("open", "/no/such/folder", code=2)
    assert done.stderr.strip() == "procc-annotator: /no/such/folder: does not exist"


@pytest.mark.parametrize(
    ("module", "function"),
    [("procc_annotator.report.scores.scoring", "run_evaluation"), ("typer.main", "get_command")],
    ids=["at work", "before it"],
)
def test_an_interrupt_leaves_no_traceback(dataset, tmp_path, module, function):
    code = (
        f"import {module} as s\n"
        "def stop(*a, **k): raise KeyboardInterrupt\n"
        f"s.{function} = stop\n"
        "import sys; from procc_annotator.cli.main import run\n"
        f"sys.argv = ['x', 'evaluate', *{dataset.set_arguments!r}]\n"
        "run()\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 130
    assert done.stderr == "procc-annotator: interrupted\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full on this system")
def test_a_character_that_the_reader_does_not_know_is_replaced():
    done = run("export", "--help", PYTHONIOENCODING="latin-1")
    assert done.returncode == 0, done.stderr
    assert "(test, valid, ?)" in done.stdout


def test_a_full_standard_output_is_one_line(dataset):
    command = [sys.executable, "-m", "procc_annotator", "evaluate", *dataset.set_arguments]
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2
    (line,) = done.stderr.splitlines()
    assert "the standard output cannot be written" in line


def test_an_unexpected_error_is_one_line_and_its_traceback_is_in_the_log(dataset, tmp_path):
    code = "from procc_annotator.batch import evaluation as run; del run.EvaluationRun\n"
    code += "from procc_annotator.cli.main import run; run()"
    done = subprocess.run(
        [sys.executable, "-c", code, "evaluate", *dataset.set_arguments],
        env={**os.environ, "XDG_DATA_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    log = tmp_path / "procc-annotator" / "log" / "errors.log"
    assert done.returncode == 3
    (line,) = done.stderr.splitlines()
    assert line.startswith("procc-annotator: unexpected error: ImportError: cannot import name")
    assert line.endswith(f"(see {log})")
    assert f"ProCC Annotator {__version__}" in log.read_text()
    assert "Traceback" in log.read_text()


def test_one_of_anything_is_told_in_the_singular(cli, dataset, tmp_path):
    match, cameras = tmp_path / "one", tmp_path / "cameras"
    match.mkdir()
    cameras.mkdir()
    for file in (dataset.root / "1.jpg", dataset.annotations / "1.json"):
        shutil.copy(file, match)
    shutil.copy(dataset.cameras / "camera_1.json", cameras)
    done = [
        cli("evaluate", match, cameras),
        cli("agree", match, match),
        cli("compare", f"a={cameras}", f"b={cameras}", match, "--pictures", tmp_path / "pictures"),
        cli("calibrate", match, tmp_path / "fitted"),
        cli("check", match),
        cli("export", match, tmp_path / "out", "--cameras", cameras),
        cli("render", match, tmp_path / "drawn"),
        cli("convert", match, tmp_path / "match.xml", "--to", "cvat"),
        cli("convert", cameras, tmp_path / "krt", "--to", "krt"),
    ]
    for one in done:
        assert one.exit_code == 0, one.stderr
        printed = one.stdout + one.stderr
        assert "1 " in printed
        many = "frames|cameras|pictures|annotations|elements|points|distances|files|classes"
        assert not re.findall(rf"(?<![\d.,])1 (?:\w+ )?(?:{many})\b", printed), printed


@pytest.mark.parametrize(
    ("command", "frames"),
    [("evaluate", 150), ("report", 150), ("calibrate", 20), ("check", 20), ("compare", 20),
     ("agree", 20)],
)  # fmt: skip
def test_two_processes_write_the_same_files(cli, dataset, tmp_path, command, frames):
    """More frames than one chunk has, in real processes."""
    second, cameras = tmp_path / "second", tmp_path / "cameras"
    for number in range(frames):
        shutil.copy(dataset.annotations / "1.json", dataset.annotations / f"again{number}.json")
        shutil.copy(
            dataset.cameras / "camera_2.json", dataset.cameras / f"camera_again{number}.json"
        )
    shutil.copytree(dataset.annotations, second)
    shutil.copytree(dataset.cameras, cameras)
    shutil.copy(second / "2.json", second / "1.json")
    shutil.copy(cameras / "camera_2.json", cameras / "camera_1.json")
    written = []
    for workers in (1, 2):
        out = tmp_path / str(workers)
        out.mkdir()
        arguments = {
            "evaluate": (*dataset.set_arguments, "-o", out / "s.json"),
            "report": (dataset.annotations, "--cameras", cameras, "-o", out / "r.json"),
            "calibrate": (dataset.annotations, out, "-m", "P"),
            "check": (dataset.annotations, "-o", out / "f.csv"),
            "compare": (dataset.cameras, f"other={cameras}", "-o", out / "c.json"),
            "agree": (dataset.annotations, second, "-o", out / "a.json"),
        }[command]
        cli(command, *arguments, "--workers", workers)
        written.append({path.name: path.read_bytes() for path in out.iterdir()})
    assert written[0] == written[1]
    assert written[0]


DEEP = b'{"a":' * 1000 + b"1" + b"}" * 1000


@pytest.mark.parametrize("reader", ["repeat", "submission", "before", "click noise"])
def test_json_nested_a_thousand_deep_is_one_line(cli, dataset, tmp_path, reader):
    file = tmp_path / ("release.json" if reader == "before" else "deep.json")
    file.write_bytes(DEEP)
    with zipfile.ZipFile(tmp_path / "sub.zip", "w") as archive:
        archive.writestr("manifest.json", DEEP)
    annotations, cameras = dataset.set_arguments[:2]
    arguments = {
        "repeat": ("repeat", file),
        "submission": ("evaluate", annotations, "--submission", tmp_path / "sub.zip"),
        "before": ("release", dataset.root, tmp_path / "out", "--previous", tmp_path),
        "click noise": ("evaluate", annotations, cameras, "--annotation-noise", file),
    }[reader]
    done = cli(*arguments, code=2)
    assert "is nested too deeply to be read (is it this file?)" in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_a_dataset_with_a_name_as_long_as_it_may_be(cli, dataset, tmp_path):
    place = dataset.root.rename(tmp_path / ("d" * 255))
    done = cli("check", place, code=None)
    assert done.exit_code in (0, 1), done.output
    assert "Checked" in done.stdout


@pytest.mark.parametrize("out", ["file/below", "d" * 256])
def test_a_folder_that_cannot_be_made_is_one_line(cli, dataset, tmp_path, out):
    (tmp_path / "file").write_bytes(b"")
    done = cli("annotate", dataset.root, tmp_path / out, "--cameras", dataset.cameras, code=2)
    assert done.stderr.splitlines()[-1].startswith(f"procc-annotator: {tmp_path / out}: ")


@pytest.mark.parametrize(
    "more",
    [
        ("convert", "--to", "yolo-pose", "--pictures"),
        ("render", "--format", "svg"),
        ("export", "--split", "test"),
        ("release", "--no-check", "--licence", "CC0-1.0"),
    ],
)
def test_a_stopped_run_goes_on_by_being_run_again(cli, dataset, tmp_path, monkeypatch, more):
    """Stopped after every file that it puts into its place, in turn."""
    command, *options = more

    def files(out: Path) -> dict[str, bytes]:
        return {
            str(path.relative_to(out)): path.read_bytes()
            for path in sorted(out.rglob("*"))
            if path.is_file() and ".procc" not in path.parts and path.suffix != ".unfinished"
        }

    cli(command, dataset.root, tmp_path / "whole", *options)
    whole = files(tmp_path / "whole")
    assert len(whole) > 4
    real = os.link, os.replace
    for stopped_at in range(1, len(whole)):
        left = stopped_at
        out = tmp_path / f"{stopped_at}"

        def stop(*names: object, call: int, **options: object) -> None:
            nonlocal left
            real[call](*names, **options)
            left -= 1
            if not left:
                raise KeyboardInterrupt

        with monkeypatch.context() as patch:
            patch.setattr(os, "link", partial(stop, call=0))
            patch.setattr(os, "replace", partial(stop, call=1))
            cli(command, dataset.root, out, *options, code=130)
        assert files(out).items() <= whole.items()
        cli(command, dataset.root, out, *options)
        assert files(out) == whole


def test_help_does_not_load_arrays_or_pictures():
    code = (
        "import sys\n"
        "from procc_annotator.cli.main import run\n"
        "sys.argv = ['procc-annotator', '--version']\n"
        "try:\n    run()\nexcept SystemExit:\n    pass\n"
        "heavy = [m for m in ('numpy', 'cv2', 'PySide6') if m in sys.modules]\n"
        "print('heavy:', heavy)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "heavy: []" in done.stdout, done.stdout + done.stderr


# Whoever reads only the first lines of what a command prints has all its files.


class ReaderLeft(Exception):
    """In place of a broken pipe, at which the command lets go of the process's own stdout."""


@pytest.fixture
def nobody_reads(monkeypatch) -> None:
    def broken(*args: object) -> None:
        raise ReaderLeft

    monkeypatch.setattr(console._Console, "_write", broken)


def test_the_comparison_is_written(cli, dataset, tmp_path, nobody_reads):
    cameras, out, pictures = dataset.root / "cameras", tmp_path / "c.json", tmp_path / "pictures"
    with pytest.raises(ReaderLeft):
        cli("compare", f"a={cameras}", f"b={cameras}", "-o", out, "--pictures", pictures)
    assert json.loads(out.read_text())
    assert list(pictures.iterdir())


def test_the_figures_over_time_are_written(cli, dataset, tmp_path, nobody_reads):
    out, shots = tmp_path / "t.json", tmp_path / "shots.csv"
    shots.write_text("frame,shot\n" + "".join(f"{name},one\n" for name in dataset.pans))
    with pytest.raises(ReaderLeft):
        cli("evaluate", dataset.root, dataset.root / "cameras", "--over-time", "--shots", shots,
            "--over-time-output", out)  # fmt: skip
    assert json.loads(out.read_text())


def test_the_dimensions_are_kept(cli, dataset, tmp_path, nobody_reads):
    match = tmp_path / "alone"
    shutil.copytree(dataset.annotations, match)
    with pytest.raises(ReaderLeft):
        cli("field-size", match, "--save")
    assert (match / ".procc").exists()
