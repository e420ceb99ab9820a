"""Commands refuse requests that make no sense, and write nothing over or among what they read."""

import shutil
import zipfile

import pytest

AMONG = "holds the files to be read"
OVER = "is one of the files to be read"
ITSELF = "this is the dataset itself"
COMPARE = "compare {cameras} {other} {root}"
EVALUATE = "evaluate {annotations} {cameras}"
AGREE = "agree {annotations} {packed_annotations}"
REPORT = "report {root} --cameras good={cameras}"


def packed(archive, folder):
    with zipfile.ZipFile(archive, "w") as file:
        for path in folder.iterdir():
            file.write(path, path.name)
    return archive


@pytest.fixture
def places(dataset, tmp_path):
    """What is read, by the words that commands are written with here."""
    other, tags, elsewhere = dataset.root / "other", tmp_path / "tags.csv", tmp_path / "elsewhere"
    shutil.copytree(dataset.cameras, other)
    tags.write_text("frame,stadium\n1,north\n")
    (tmp_path / "empty").mkdir()
    (tmp_path / "file").write_text("")
    elsewhere.mkdir()  # a camera of no frame that is annotated
    shutil.copy(dataset.cameras / "camera_1.json", elsewhere / "camera_00003.json")
    alias = tmp_path / "alias.json"
    alias.symlink_to(dataset.cameras / "camera_1.json")
    return {
        "root": dataset.root, "annotations": dataset.annotations, "cameras": dataset.cameras,
        "other": other, "tags": tags, "alias": alias, "elsewhere": elsewhere, "tmp": tmp_path,
        "empty": tmp_path / "empty", "file": tmp_path / "file", "out": tmp_path / "out",
        "packed_cameras": packed(tmp_path / "cameras.zip", dataset.cameras),
        "packed_annotations": packed(tmp_path / "annotations.zip", dataset.annotations),
    }  # fmt: skip


@pytest.mark.parametrize(
    ("command", "said"),
    [
        (f"{EVALUATE} -o {{annotations}}/1.json", OVER),
        (f"{EVALUATE} --tags {{tags}} -o {{tags}}", OVER),
        (f"{AGREE} -o {{annotations}}/1.json", OVER),
        (f"{COMPARE} -o {{cameras}}/camera_1.json", OVER),
        (f"{COMPARE} -o {{other}}/camera_1.json", OVER),
        (f"{COMPARE} -o {{annotations}}/1.json", OVER),
        (f"{COMPARE} -o {{alias}}", OVER),
        (f"{COMPARE} -o {{other}}/compared.json", AMONG),  # would be a camera the next time
        (f"{COMPARE} --pictures {{cameras}}", AMONG),
        (f"{COMPARE} --pictures {{other}}", AMONG),
        (f"{COMPARE} --pictures {{annotations}}", AMONG),
        (f"{COMPARE} --pictures {{root}}", ITSELF),
        ("export {root} {root}", ITSELF),
        ("export {root} {annotations}", "holds 1.json"),
        ("export {root} {cameras} --cameras {cameras}", AMONG),
        ("export {root} {packed_cameras} --cameras {packed_cameras}", OVER),
        ("calibrate {root} {annotations}", AMONG),
        ("calibrate {packed_annotations} {packed_annotations}", OVER),
        ("check {root} -o {annotations}/1.json", OVER),
        ("check {root} -o {annotations}/found.json", AMONG),
        ("render {root} {root} --format jpg", "holds 1.jpg"),
        ("render {root} {cameras} --cameras {cameras}", AMONG),
        ("render {root} {annotations} --cameras {cameras}", AMONG),
        ("propose {root} {cameras} --known-positions {cameras}", AMONG),
        ("convert {root} {root} --to labelme", "lies in what is read"),
        ("convert {root} {root}/masks --to masks", "lies in what is read"),
        ("release {root} {root}/release --no-check", "lies in what is read"),
    ],
)
def test_nothing_is_written_over_or_among_what_is_read(cli, places, command, said):
    _refused(cli, places, command, said)


def _refused(cli, places, command, said):
    """It ends with one line, or that of the parser of options, and changes no file."""
    before = {path: path.read_bytes() for path in places["tmp"].rglob("*") if path.is_file()}
    done = cli(*(word.format(**places) for word in command.split()), code=2)
    lines = done.stderr.splitlines()
    assert lines[0].startswith("Usage: ") or len(lines) == 1
    assert said in done.stderr
    assert done.stdout == ""
    after = {path: path.read_bytes() for path in places["tmp"].rglob("*") if path.is_file()}
    assert after == before
    assert not places["out"].exists()


@pytest.mark.parametrize(
    ("command", "said"),
    [
        (f"{EVALUATE} --protocol sokkernet", "soccernet"),
        (f"{EVALUATE} --size 960", "WIDTHxHEIGHT"),
        (f"{EVALUATE} --threshold 0", "positive"),
        (f"{EVALUATE} --threshold nan", "positive"),
        (f"{EVALUATE} --mirrored", "procc"),
        (f"{EVALUATE} --field cricket", "cricket"),
        (f"{EVALUATE} --off-plane maybe", "maybe"),
        (f"{EVALUATE} --camera-format fbx", "fbx"),
        (f"{EVALUATE} --output scores.xlsx", ".json or .csv"),
        (f"{EVALUATE} --output /dev/null/at/all/scores.json", "/dev/null/at/all"),
        (f"{EVALUATE} --workers 0", "workers"),
        (f"{EVALUATE} --dask here", "HOST:PORT"),
        (f"{EVALUATE} --dask tcp://localhost:1 --workers 2", "give one of them"),
        (f"{EVALUATE} --size 960x540 --size wide", "WIDTHxHEIGHT"),
        (f"{EVALUATE} --by stadium", "--tags"),
        (f"{EVALUATE} --tags /nowhere/tags.csv", "/nowhere/tags.csv"),
        (f"{EVALUATE} --set a=b", "--set NAME=ANNOTATIONS"),
        (f"{EVALUATE} --cameras a=b", "--cameras NAME=PATH"),
        ("evaluate {empty} {cameras}", "no annotation"),
        ("evaluate {annotations} {empty}", "no camera"),
        ("evaluate {annotations} {elsewhere}", "'00003'"),
        ("evaluate {tmp}/absent {cameras}", "absent"),
        ("compare {cameras} {tmp}/nothing", "does not exist"),
        ("compare {cameras} {cameras}", "two sources of cameras are called 'cameras'"),
        ("compare {cameras} b:wc14={other}", "b has no camera (format wc14)"),
        ("compare {cameras} {elsewhere}", "no frame has cameras of both"),
        ("compare {cameras} {other} -o {tmp}/out.txt", ".json or .csv"),
        ("compare {cameras} {other} --versus {elsewhere}", "no frame has cameras of both"),
        ("compare {cameras} {other} --tags {tags}", "need --intervals"),
        ("compare {cameras} {other} --seed 3", "need --intervals"),
        (f"{EVALUATE} --interval-method bca", "need --intervals"),
        (f"{EVALUATE} --resamples 500", "need --intervals"),
        (f"{EVALUATE} --seed 3", "need --intervals"),
        (f"{AGREE} -t -1", "a threshold must be a positive number"),
        (f"{AGREE} -o {{tmp}}/out.txt", "written as .json or .csv"),
        (f"{AGREE} -o {{file}}/none/out.csv", "is a file, expected a folder"),
        (f"{AGREE} --field tennis-court", "tennis-court"),
        ("agree {annotations} {empty}", "nothing to do: no annotation"),
        ("agree {annotations} {tmp}/none", "no such file or folder"),
        (f"{REPORT} --output x.pdf", "a report is written as .html, .csv, .json, .tex"),
        (f"{REPORT} --output {{out}}.html --reference nobody", "no source called 'nobody'"),
        (f"{REPORT} --output {{out}}.html --disagreement one", "is no pair of sources"),
        (f"{REPORT} --output {{out}}.html --disagreement good,good", "name two"),
        (f"{REPORT} --output /dev/null/r.html", "/dev/null is a file, expected a folder"),
        ("calibrate {root} {out} --model Q", "choose one of H, P, R, R+"),
        ("calibrate {root} {out} --model r+", "did you mean R+"),
        ("calibrate {root} {out} --field soccr", "soccer"),
        ("calibrate {empty} {out}", "nothing to do"),
        ("calibrate {tmp}/none {out}", "no such file or folder"),
        ("calibrate {root} {file}", "a folder is needed"),
        ("propose {tmp}/nowhere {out}", "does not exist"),
        ("propose {root} {out}", "all frames are annotated"),
        ("propose {root} {out} --known-positions {tmp}/no", "does not exist"),
        ("propose {cameras} {out}", "no picture in"),
        ("check {root} --model Q", "choose one of H, P, R, R+"),
        ("check {root} --min-severity fatal", "choose one of error, warning, hint"),
        ("check {root} --fail-on x", "choose one of error, warning, hint"),
        ("check {root} --output findings.txt", ".csv or .json"),
        ("check {root} --output /dev/null/findings.csv", "/dev/null is a file, expected a folder"),
        ("check {empty}", "nothing to do"),
        ("export {tmp}/absent {out}", "absent"),
        ("export {cameras} {out}", "nothing to do"),
        ("export {root} {out} --cameras {tmp}/absent", "absent"),
        ("export {root} {file}", "file"),
        ("export {root} {file}/out", "file"),
        ("export {root} {file}/out.zip", "file"),
        ("render {root} {out} --scale 0", "scale"),
        ("convert {root} {out}.xml --to coco", "expected a name that ends in .json"),
        ("convert {root} {out}.json --to cvat", "expected a name that ends in .xml"),
        ("convert {root} {out} --to paint", "no format 'paint'"),
        ("convert {root} {out} --to cvat --from masks", "only be written"),
        ("convert {root} {out} --to cvat --from nothing", "no annotation fo"),
        ("convert {tmp}/gone {out} --to cvat", "no such file or folder"),
        ("convert {cameras} {out} --to cvat", "nothing to do"),
        ("convert {root} {out} --to masks --line-width 0", "line width"),
        ("convert {root} {out} --to labelme --split ../up", "name of a folder"),
        ("convert {root} {out} --to cvat --into {tmp}/a", "written into"),
    ],
)
def test_a_request_that_makes_no_sense_is_one_line(cli, places, command, said):
    _refused(cli, places, command, said)
