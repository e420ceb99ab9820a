"""Overlay pictures from the window and from `render`: kinds, scale, legend."""

import xml.etree.ElementTree as ElementTree

import cv2
import numpy as np
import pytest
from PySide6.QtWidgets import QDialogButtonBox, QFileDialog

from procc_annotator.errors import UsageError
from procc_annotator.gui.canvas.overlay_picture import OverlayPictures
from procc_annotator.gui.commands.overlay_saving import OverlayDialog, OverlaySaving
from procc_annotator.gui.state.services import Services
from procc_annotator.report.overlay_scene import OverlayLook, Scene

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def services(open_services, annotated) -> Services:
    services = open_services(annotated)
    assert services.camera_sources.load_cameras(annotated / "cameras" / "bad")
    assert services.scorer.score is not None
    return services


@pytest.fixture
def saving(services, widget) -> OverlaySaving:
    return OverlaySaving(services, widget)


def scene_of(services: Services, **changes) -> Scene:
    given = {
        "image_path": services.state.frame.image_path,
        "annotation": services.state.annotation,
        "setup": services.state.setup,
        "measurement": services.scorer.measurement,
        "score": services.scorer.score,
        "title": "A <frame> & more",
    }
    return Scene(**(given | changes))


def decoded(data: bytes) -> np.ndarray:
    picture = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)
    assert picture is not None
    return picture


@pytest.mark.parametrize("scale", [0.5, 1.0, 2.0])
def test_pixels_come_at_any_scale(services, scale):
    width, height = services.state.picture_size
    plain = decoded(OverlayPictures(".png", OverlayLook(scale))(scene_of(services)))
    assert plain.shape[:2] == (round(height * scale), round(width * scale))
    with_legend = decoded(
        OverlayPictures(".png", OverlayLook(scale, legend=True))(scene_of(services))
    )
    assert with_legend.shape[1] == plain.shape[1]
    band = with_legend[plain.shape[0] :]
    assert len(band) >= 30
    assert tuple(band[-1, -1]) == (0x20, 0x20, 0x20)
    assert (band.min(axis=2) > 200).sum() > 200  # white text


def test_svg_keeps_text_and_says_what_it_is(services):
    scene = scene_of(services)
    data = OverlayPictures(".svg", OverlayLook(2.0, legend=True))(scene)
    root = ElementTree.fromstring(data)
    width, height = services.state.picture_size
    assert root.get("width") == str(2 * width)
    shown_height = float(root.get("height"))
    assert shown_height > 2 * height
    assert root.get("viewBox") == f"0 0 {2 * width} {shown_height:g}"
    assert root.findtext(f"{SVG}title") == "A <frame> & more"
    assert "soccernet, 960x540" in (root.findtext(f"{SVG}desc") or "")
    (image,) = root.iter(f"{SVG}image")
    assert image.get("width") == str(2 * width)
    pixels = image.get("{http://www.w3.org/1999/xlink}href")
    assert pixels.startswith("data:image/jpeg;base64,")
    texts = ["".join(t.itertext()) for t in root.iter(f"{SVG}text")]
    assert any(t.startswith("too far: a point") for t in texts)
    assert "distances: px of 960x540" in texts
    jac = services.scorer.score.jac
    assert any(f"JaC@5 {jac:.3f}" in t and "soccernet, 960x540" in t for t in texts)
    order = [element.tag for element in root]
    assert order.index(f"{SVG}image") < order.index(f"{SVG}g")  # below the lines


def test_without_a_picture_ground_is_drawn(services):
    scene = scene_of(services, image_path=None)
    picture = decoded(OverlayPictures(".png", OverlayLook(caption=False))(scene))
    assert picture.shape == (540, 960, 3)
    assert len(np.unique(picture[:20, :20].reshape(-1, 3), axis=0)) == 1
    root = ElementTree.fromstring(OverlayPictures(".svg")(scene))
    assert not list(root.iter(f"{SVG}image"))


def test_what_cannot_be_made_is_said():
    with pytest.raises(UsageError, match="scale"):
        OverlayLook(100.0)
    with pytest.raises(UsageError, match=r"\.gif"):
        OverlayPictures(".gif")


def test_the_menu_asks_and_writes(said, saving, annotated, tmp_path, monkeypatch, qtbot):
    out = tmp_path / "figure"

    def choose(self: OverlayDialog) -> int:
        assert "1280 x 720" in self.result_size.text()
        self.kind.setCurrentIndex(self.kind.findData(".svg"))
        self.scale.setValue(1.5)
        assert "1920 x 1080" in self.result_size.text()
        return int(OverlayDialog.DialogCode.Accepted)

    monkeypatch.setattr(OverlayDialog, "exec", choose)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(out), ""))
    saving.ask()
    written = out.with_suffix(".svg")
    qtbot.waitUntil(lambda: len(said) == 2)
    assert ElementTree.parse(written).getroot().get("width") == "1920"
    assert said[-1] == f"overlay picture written to {written}"


def test_the_window_goes_on_while_a_large_picture_is_written(
    said, saving, services, annotated, tmp_path, qtbot
):
    expected = decoded(
        OverlayPictures(".png", OverlayLook(3.0, legend=True))(
            scene_of(services, title=services.state.frame.name, source="bad")
        )
    )
    said: list[tuple[str, str]] = []
    services.store.events.message.connect(lambda m: said.append((m.text, m.level)))
    out = tmp_path / "large.png"
    assert saving.write(out, OverlayLook(3.0, legend=True))
    assert not out.exists()  # nobody waited for it
    services.navigator.next_frame()  # what is written is what was on screen then
    qtbot.waitUntil(out.exists)
    assert np.array_equal(decoded(out.read_bytes()), expected)
    qtbot.waitUntil(lambda: said[-1] == (f"overlay picture written to {out}", "info"))
    assert saving.write(tmp_path / "none" / "x.png", OverlayLook())
    qtbot.waitUntil(lambda: said[-1][1] == "error")
    assert "x.png" in said[-1][0]


def test_a_scale_that_makes_too_many_pixels_is_not_offered(qtbot):
    dialog = OverlayDialog((1280, 720))
    qtbot.addWidget(dialog)
    save = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)
    dialog.scale.setValue(16.0)
    assert "too large" in dialog.result_size.text()
    assert not save.isEnabled()
    dialog.kind.setCurrentIndex(dialog.kind.findData(".svg"))
    assert save.isEnabled()
    dialog.kind.setCurrentIndex(dialog.kind.findData(".png"))
    dialog.scale.setValue(8.0)
    assert save.isEnabled()


def test_the_picture_itself_is_never_replaced(saving, services):
    path = services.state.frame.image_path
    before = path.read_bytes()
    assert not saving.write(path, OverlayLook())
    assert path.read_bytes() == before
