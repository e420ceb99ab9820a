"""The elements of a fit as table rows, worst first, and its camera as a few lines of figures."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtGui import QFont

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.result import ElementResidual, FitResult, PosedCamera
from procc_annotator.field.model import Field
from procc_annotator.gui.panels.rows import RIGHT, ElementRowsModel, Index
from procc_annotator.gui.panels.states import class_title
from procc_annotator.translation import tr, word

ELEMENT, MEAN, LARGEST = range(3)
_HEADERS = (word("Element"), word("Mean"), word("Largest"))
_HEADER_TIPS = (
    word("Worst first; a click shows the worst point"),
    word("Mean distance of its points to the fitted element, px of the picture"),
    word("Largest distance of its points to the fitted element, px of the picture"),
)


class FitRow(NamedTuple):
    """One element.

    Attributes:
        point: position of the worst point in the polyline; None if unknown.
        left_out: whether the fit took it for a mistake.
    """

    class_name: str
    title: str
    mean: str
    largest: str
    point: int | None
    left_out: bool

    @property
    def words(self) -> str:
        """The title; what was left out says so."""
        return tr("✕ left out: {title}", title=self.title) if self.left_out else self.title


def fit_rows(fit: FitResult, annotation: FrameAnnotation, field: Field) -> list[FitRow]:
    """The elements of a fit, the one with the largest distance first."""
    ordered = sorted(fit.elements, key=lambda element: -element.max_px)
    return [
        FitRow(
            element.name,
            class_title(field, element.name),
            f"{element.mean_px:.1f}",
            f"{element.max_px:.1f}",
            _worst_point(element, annotation, fit.size),
            element.left_out,
        )
        for element in ordered
    ]


def _worst_point(
    element: ElementResidual, annotation: FrameAnnotation, size: tuple[int, int]
) -> int | None:
    """Return where in its polyline the point with the largest distance is."""
    polyline = annotation.get(element.name)
    distances = element.distances_of(polyline, size) if polyline is not None else {}
    return max(distances, key=distances.__getitem__, default=None)


class FitTableModel(ElementRowsModel[FitRow]):
    """How far each element lies off the fitted camera."""

    def __init__(self) -> None:
        super().__init__(_HEADERS, _HEADER_TIPS, MEAN)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row, column = self.rows[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return (row.words, row.mean, row.largest)[column]
        if role == Qt.ItemDataRole.TextAlignmentRole and column >= MEAN:
            return RIGHT
        if role == Qt.ItemDataRole.FontRole and row.left_out:
            font = QFont()
            font.setItalic(True)
            return font
        if role == Qt.ItemDataRole.ToolTipRole:
            words = tr(
                "{title}: mean {mean} px, largest {largest} px",
                title=row.title,
                mean=row.mean,
                largest=row.largest,
            )
            if row.left_out:
                words += "\n" + tr("Taken for a mistake: it had no say in the fit")
            return words
        return None


def pose_figures(fit: FitResult) -> list[tuple[str, str, str]]:
    """Return what the camera is and how surely, line by line: name, value, standard deviation;
    empty for a homography, which has no pose."""
    camera, sd = fit.camera, fit.deviations
    if not isinstance(camera, PosedCamera) or sd is None:
        return []
    angles = (
        (tr("Pan", "an angle"), camera.pan_rad, sd.pan_rad),
        (tr("Tilt"), camera.tilt_rad, sd.tilt_rad),
        (tr("Roll"), camera.roll_rad, sd.roll_rad),
    )
    focal = camera.focal_px[0]
    share = 100 * sd.focal_px / focal
    x, y, z = camera.position_world
    along, across, height = sd.position_m
    return [
        *((name, f"{math.degrees(v):.2f}°", f"± {math.degrees(s):.2f}°") for name, v, s in angles),
        (tr("Focal length"), f"{focal:.0f} px", f"± {sd.focal_px:.0f} px ({share:.1f} %)"),
        (tr("Along (x)"), f"{x:z.1f} m", f"± {along:.1f} m"),
        (tr("Across (y)"), f"{y:z.1f} m", f"± {across:.1f} m"),
        (tr("Height (−z)"), f"{-z:z.1f} m", f"± {height:.1f} m"),
    ]
