"""Overlay pictures as arrays, findings, and where a camera shows the field."""

from __future__ import annotations

import subprocess
import sys

import cv2
import numpy as np
import pytest

from procc_annotator import (
    FrameAnnotation,
    ImageError,
    UsageError,
    check_labels,
    draw_overlay,
    evaluate,
    fit_camera,
    load_annotation,
    load_camera,
    project_field,
)


def test_an_overlay_is_a_picture(sample_data) -> None:
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


def test_a_camera_of_another_size_is_drawn_in_its_place(sample_data) -> None:
    picture = cv2.imread(str(sample_data / "00002.jpg"))
    height, width = picture.shape[:2]
    annotation = load_annotation(sample_data / "00002.json")
    small = fit_camera(annotation, size=(960, 540))
    assert small.size != (width, height)
    told = draw_overlay(picture, None, small)
    plain = draw_overlay(picture, None, small.camera, camera_size=(960, 540))
    assert (told == plain).all()
    assert (told != draw_overlay(picture, None, small.camera)).any()


def test_what_cannot_be_drawn(tmp_path) -> None:
    with pytest.raises(ImageError, match=r"no\.jpg"):
        draw_overlay(tmp_path / "no.jpg")
    with pytest.raises(UsageError, match="expected a picture"):
        draw_overlay(np.zeros((4, 4)))
    picture = np.zeros((90, 160, 3), np.uint8)
    with pytest.raises(UsageError, match="expected an annotation"):
        draw_overlay(picture, {"Middle line": []})
    with pytest.raises(UsageError, match="the scale must be"):
        draw_overlay(picture, scale=0)


def test_pieces_of_the_field_in_a_picture(sample_data) -> None:
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


def test_mistakes_are_found(sample_data) -> None:
    annotation = load_annotation(sample_data / "00002.json")
    assert not [f for f in check_labels(annotation) if f.severity == "error"]
    lines = annotation.to_dict()
    first, second = [name for name, points in lines.items() if len(points) > 1][:2]
    lines[first], lines[second] = lines[second], lines[first]
    found = check_labels(FrameAnnotation.from_dict(lines), picture=sample_data / "00002.jpg")
    assert {first, second} & set(found[0].elements)
    assert found[0].severity == "error"
    assert found[0].reason


def test_nothing_of_it_needs_qt(sample_data) -> None:
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
