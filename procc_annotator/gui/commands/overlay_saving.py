"""Save the picture on screen with its overlay: PNG, JPEG or SVG, at any scale, with a legend."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLabel,
    QWidget,
)

from procc_annotator.errors import ProccError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.canvas.overlay_picture import OverlayPictures
from procc_annotator.gui.commands.dialogs import NamedDialog, dialog_buttons
from procc_annotator.gui.messages import ask_where, write
from procc_annotator.gui.panels.widgets import DecimalBox
from procc_annotator.gui.state.services import Services
from procc_annotator.report.overlay_scene import (
    MAX_SCALE,
    MIN_SCALE,
    MOST_PIXELS,
    SUFFIXES,
    OverlayLook,
    Scene,
)
from procc_annotator.translation import tr, word

_KINDS = {
    ".png": word("PNG: pixels, nothing is lost"),
    ".jpg": word("JPEG: pixels, small"),
    ".svg": word("SVG: lines and text stay sharp"),
}

_RESULT = word("{width} x {height} px, without the legend")
_TOO_LARGE = word("{width} x {height} px, too large: choose a smaller scale or SVG")


class OverlayDialog(NamedDialog):
    """Asks for the kind, the scale and the legend of a picture (width, height), px."""

    def __init__(self, size: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent, "overlayDialog", tr("Save overlay picture"))
        self._size = size
        self.kind = QComboBox()
        for suffix in SUFFIXES:
            self.kind.addItem(tr(_KINDS[suffix]), suffix)
        self.scale = DecimalBox(MIN_SCALE, MAX_SCALE, 0.5)
        self.scale.setValue(1.0)
        self.scale.setToolTip(
            tr("Px of the result per px of the picture; lines and text grow with it")
        )
        self.result_size = QLabel()
        self.legend = QCheckBox(tr("Explain colours, dashes and marks below the picture"))
        self.legend.setChecked(True)
        form = QFormLayout(self)
        form.addRow(tr("&Kind"), self.kind)
        form.addRow(tr("&Scale"), self.scale)
        form.addRow(tr("Result"), self.result_size)
        form.addRow(tr("&Legend"), self.legend)
        buttons, self._save = dialog_buttons(self, QDialogButtonBox.StandardButton.Save)
        form.addRow(buttons)
        self.scale.valueChanged.connect(self._show_size)
        self.kind.currentIndexChanged.connect(self._show_size)
        self._show_size()

    @property
    def suffix(self) -> str:
        """The chosen kind."""
        return str(self.kind.currentData())

    @property
    def look(self) -> OverlayLook:
        """The chosen look."""
        return OverlayLook(self.scale.value(), self.legend.isChecked())

    def _show_size(self) -> None:
        width, height = (round(side * self.scale.value()) for side in self._size)
        painted = self.suffix != ".svg"  # an SVG has no pixels of its own
        too_large = painted and width * height > MOST_PIXELS
        words = _TOO_LARGE if too_large else _RESULT
        self.result_size.setText(tr(words, width=width, height=height))
        self._save.setEnabled(not too_large)


class OverlaySaving:
    """Saves what is on screen; in blind mode without the projection, as on screen."""

    def __init__(self, services: Services, parent: QWidget) -> None:
        self._services = services
        self._parent = parent

    def ask(self) -> None:
        """Ask how and where, and write."""
        services = self._services
        frame, size = services.state.frame, services.state.picture_size
        if frame is None or size is None:
            services.say(tr("open a picture first"), "warning")
            return
        dialog = OverlayDialog(size, self._parent)
        accepted = dialog.exec() == QDialog.DialogCode.Accepted
        suffix, look = dialog.suffix, dialog.look
        dialog.deleteLater()
        if not accepted:
            return
        name = f"{frame.name.replace('/', '_')}_overlay{suffix}"
        kind = tr("Picture (*{suffix})", suffix=suffix)
        path = ask_where(services, self._parent, tr("Save overlay picture"), name, kind)
        if path is not None:
            self.write(path, look)

    def write(self, path: Path, look: OverlayLook) -> bool:
        """Begin to write the frame on screen in the background; the suffix says which kind. False
        if that did not begin; what came of it is a message."""
        services = self._services
        frame = services.state.frame
        if frame is None:
            return False
        if path.resolve() == frame.image_path.resolve():
            services.say(
                tr("{path}: is the picture itself, choose another name", path=path),
                "error",
                "save_overlay",
            )
            return False
        scene = Scene(
            frame.image_path,
            services.state.annotation,
            services.state.setup,
            services.scorer.measurement,
            services.scorer.score,
            frame.name,
            "" if services.state.active is None else services.state.active.name,
            services.line_widths.value,
        )
        try:
            draw = OverlayPictures(path.suffix.lower(), look)
        except ProccError as error:
            services.say(str(error), "error", "save_overlay")
            return False
        services.say(tr("writing the overlay picture {path} …", path=path))
        write(
            services,
            lambda _: write_atomic(path, draw(scene)),
            lambda _: tr("overlay picture written to {path}", path=path),
            again="save_overlay",
        )
        return True
