"""Files made to do harm are refused in one line, before they cost time or memory."""

import io
import json
import pickle
import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.errors import AnnotationError, CameraError, FieldError, InputError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera
from tests.fuzz.readers import FIELD, GOOD_CAMERA, ROOT, SOCCER, in_one_line

# ------------------------------------------------------------------------------- nothing is run


class Bomb:
    def __init__(self, target: Path) -> None:
        self.target = target

    def __reduce__(self) -> tuple[Any, ...]:
        return (Path.touch, (self.target,))


def objects(target: Path) -> dict[str, bytes]:
    """Python objects in every wrapping that numpy and Python know."""
    array = np.array([Bomb(target)] * 9, dtype=object).reshape(3, 3)
    saved, zipped = io.BytesIO(), io.BytesIO()
    np.save(saved, array, allow_pickle=True)
    np.savez(zipped, array)
    return {
        "an object array": saved.getvalue(),
        "an archive of arrays": zipped.getvalue(),
        "bare": pickle.dumps(Bomb(target)),
        "bare, as text": pickle.dumps(Bomb(target), protocol=0),
    }


@pytest.mark.parametrize("name", ["1.npy", "1.homographyMatrix", "camera_1.json"])
@pytest.mark.parametrize(
    "kind", ["an object array", "an archive of arrays", "bare", "bare, as text"]
)
def test_python_objects_are_refused_and_never_built(tmp_path, kind, name):
    target = tmp_path / "ran"
    with pytest.raises(CameraError) as caught:
        read_camera_file(objects(target)[kind], path=name)
    text = in_one_line(caught, name)
    assert any(
        word in text for word in ("not a readable .npy", "UTF-8", "not valid JSON", "expected")
    )
    assert not target.exists()


def test_arrays_are_never_loaded_with_objects():
    """Other ways to run what a file contains are lint errors (pyproject.toml)."""
    files = sorted((ROOT / "procc_annotator").rglob("*.py"))
    text = "\n".join(f.read_text(encoding="utf-8") for f in files)
    assert len(files) > 60
    assert set(re.findall(r"allow_pickle\s*=\s*(\w+)", text)) == {"False"}
    assert text.count("allow_pickle") == len(re.findall(r"\b(?:np|numpy)\.(?:load|save)\(", text))


# ----------------------------------------------------------------------------- numbers and depth


@pytest.mark.parametrize("digits", [309, 4300, 4301, 1_000_000])
def test_whole_numbers_of_thousands_of_digits(tmp_path, digits):
    number = "9" * digits
    text = f'{{"Circle left": [{{"x": 0, "y": {number}}}]}}'
    with pytest.raises(AnnotationError) as caught:
        read_annotation(text.encode(), path="1.json", field=FIELD)
    in_one_line(caught, "1.json")
    for key in ("pan_degrees", "x_focal_length", "image_width"):
        camera = json.dumps({**GOOD_CAMERA, "image_height": 540, key: "HERE"})
        with pytest.raises(CameraError) as wrong:
            read_camera_file(camera.replace('"HERE"', number).encode(), path="1.json")
        in_one_line(wrong, "1.json")
    with pytest.raises(CameraError) as wrong:
        read_camera_file(f"{number} 0 0 0 1 0 0 0 1".encode(), path="1.txt")
    in_one_line(wrong, "1.txt")
    path = tmp_path / "f.toml"
    spellings = (number, "-" + number, "0x" + "f" * min(digits, 9000))
    for spelled in spellings:
        for old in ('title = "Soccer"', 'radius = "circle_radius"', 'kind = "circle"'):
            path.write_text(SOCCER.replace(old, f"{old.split()[0]} = {spelled}", 1))
            with pytest.raises(FieldError) as refused:
                load_field(path)
            in_one_line(refused, str(path))


def accepted(read: Callable[..., Any], text: str) -> Any:
    """What is read; None when it is refused for its depth."""
    try:
        return read(text.encode(), path="1.json")
    except InputError as error:
        if not str(error).startswith("1.json: is nested too deeply"):
            raise
        return None


@pytest.mark.parametrize("depth", [60, 70, 300, 900, 960, 980, 990, 1000, 100_000])
def test_what_is_nested_is_refused_or_can_be_written_again(depth):
    nested = "[" * depth + "]" * depth
    for text in (
        f'{{"meta": {{"deep": {nested}}}}}',
        f'{{"Circle left": [], "a": {{"b": {nested}}}}}',
    ):
        annotation = accepted(partial(read_annotation, field=FIELD), text)
        assert (annotation is None) == (depth > 65)
        if annotation is not None:
            assert json.loads(write_annotation(annotation)) == json.loads(text)
    camera = json.dumps({**GOOD_CAMERA, "deep": "HERE"}).replace('"HERE"', nested)
    loaded = accepted(read_camera_file, camera)
    assert (loaded is None) == (depth > 65)
    if loaded is not None:
        assert json.loads(write_camera(loaded.camera, loaded.content)) == json.loads(camera)


def test_what_stands_in_a_file_cannot_command_the_terminal(tmp_path):
    evil = "\x1b]0;owned\x07\x1b[2J\u202e\u2028" + "x" * 100_000
    contents: list[dict[str, Any]] = [
        {evil: [[]]},
        {evil: [1, {"x": 1}]},
        {"Circle left": [{"x": evil, "y": 0}]},
    ]
    for content in contents:
        for data in (json.dumps(content), json.dumps(content).replace("{", '{"a": 1, "a": 2,', 1)):
            with pytest.raises(AnnotationError) as caught:
                read_annotation(data.encode(), path="1.json", field=FIELD)

            in_one_line(caught, "1.json")
    with pytest.raises(CameraError) as refused:
        read_camera_file(json.dumps({**GOOD_CAMERA, "pan_degrees": evil}).encode(), path="1.json")
    in_one_line(refused, "1.json")
    path = tmp_path / "f.toml"
    quoted = json.dumps(evil)
    for old, new in (
        ("[formulas]", f'{quoted} = 1\n[formulas]\n{quoted} = "1"'),
        ("[formulas]", f'[formulas]\n{quoted} = "1"'),
        ("symmetries = [180]", f"symmetries = [{quoted}]"),
        ('kind = "circle"', f"kind = {quoted}"),
        ('name = "Circle left"', f"name = {quoted}"),
        ('"circle_radius"', quoted),
    ):
        path.write_text(SOCCER.replace(old, new, 1), encoding="utf-8")
        with pytest.raises(FieldError) as wrong:
            load_field(path)
        in_one_line(wrong, str(path))
