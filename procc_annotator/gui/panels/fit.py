"""The camera that the clicks of this frame give: which model, how well, how surely, and saving."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QAction, QFont
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QTableView,
    QWidget,
)

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import FrameAnalysis
from procc_annotator.calibration.result import (
    ILL_CONDITIONED_LIMITS,
    ElementResidual,
    FitResult,
    PosedCamera,
    ill_conditioned_reason,
)
from procc_annotator.camera.base import projects_only_ground
from procc_annotator.field.model import Field
from procc_annotator.gui.panels.element_states import ElementState, class_title, fly_to_point
from procc_annotator.gui.panels.widgets import (
    ElementRowsModel,
    ElementTable,
    Pages,
    Panel,
    ScrolledContent,
    box_of,
    caption,
    choice,
    hbox,
    make_button,
    make_label,
    note_label,
    scrolling,
    show_note,
    vbox,
)
from procc_annotator.gui.state.availability import as_sentence
from procc_annotator.gui.state.prediction.live_fit import MODELS
from procc_annotator.gui.state.scoring.frame_score import CachedScore
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import fixed_width
from procc_annotator.metrics.score import FrameScore
from procc_annotator.translation import tr, tr_count, word

ELEMENT, MEAN, LARGEST = range(3)
_HEADERS = (word("Element"), word("Mean"), word("Largest"))
_HEADER_TIPS = (
    word("Worst first; a click shows the worst point"),
    word("Mean distance of its points to the fitted element, px of the picture"),
    word("Largest distance of its points to the fitted element, px of the picture"),
)


class FitRow(NamedTuple):
    """One element; ``point``: place of the worst point in the polyline, None if unknown;
    ``left_out``: whether the fit took it for a mistake."""

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
    """Distances of each element from the fitted camera."""

    def __init__(self) -> None:
        super().__init__(_HEADERS, _HEADER_TIPS, MEAN)

    def texts(self, row: FitRow) -> Sequence[str]:
        return row.words, row.mean, row.largest

    def font(self, row: FitRow) -> QFont | None:
        font = QFont()
        font.setItalic(True)
        return font if row.left_out else None

    def tip(self, row: FitRow) -> str:
        words = tr(
            "{title}: mean {mean} px, largest {largest} px",
            title=row.title,
            mean=row.mean,
            largest=row.largest,
        )
        left_out = tr("Taken for a mistake: it had no say in the fit")
        return f"{words}\n{left_out}" if row.left_out else words


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


_GREY_AFTER_MS = 100  # most fits are there by then


class FitPanel(Panel):
    """Displays the live fit; a click on an element flies to its worst point."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "fit_panel", (300, 360))
        self._shown: FrameAnalysis | None = None
        self._frame: str | None = None
        self._opinion = CachedScore()
        self._build()
        self._slow = QTimer(self, singleShot=True, interval=_GREY_AFTER_MS)
        self._slow.timeout.connect(self._say_working)
        self._follow(
            lambda s: (judged(s), s.selection, s.looks, s.blind_lock),
            services.live_fit.changed,
        )

    # --- building ------------------------------------------------------------------------------

    def _build(self) -> None:
        tip = tr("Elements in sight that are not annotated count against the JaC")
        self.counted = note_label("fit_counted", tip)
        self.chosen = note_label("fit_chosen")
        tip = tr("Hardly determined: {limits}", limits=ILL_CONDITIONED_LIMITS)
        self.weak = note_label("fit_weak", tip)
        self.weak.setTextFormat(Qt.TextFormat.RichText)
        self.terms = note_label("fit_terms")
        self.model = choice(
            "fit_model",
            tip=tr("What is fitted. Automatically: the simplest model that the clicks support"),
            items=[(tr(words), model) for model, words in MODELS.items()],
            chosen=self._services.live_fit.set_model,
        )
        self.content = ScrolledContent()
        vbox(
            self._build_headline(),
            self.counted,
            self.weak,
            self.chosen,
            self.terms,
            (self._build_table(), 1),
            self._build_pose(),
            of=self.content,
            spacing=6,
            margins=0,
        )
        self._pages = Pages(scrolling(self.content), "fit_empty")
        self.empty = self._pages.empty
        self._buttons = vbox()
        choose = caption(tr("Model"), self.model)
        vbox(choose, (self._pages, 1), self._buttons, of=self, spacing=6, margins=6)

    def _build_headline(self) -> QHBoxLayout:
        font = fixed_width(self.font(), 1.6, bold=True)
        self.jac = make_label(name="fit_jac", font=font)
        self.at_tau = make_label(name="fit_tau")
        tip = tr("Mean distance of the points that had a say, px of the picture")
        self.mean = make_label(name="fit_mean", font=font, tip=tip)
        pairs = ((self.jac, self.at_tau), (self.mean, QLabel(tr("mean residual"))))
        return hbox(*((vbox(*pair, spacing=0), 1) for pair in pairs))

    def _build_table(self) -> QTableView:
        self.rows = FitTableModel()
        self.table = ElementTable(
            "fit_table", self.rows, {MEAN: f"{tr('Mean')}  ", LARGEST: f"{tr('Largest')}  "}
        )
        self.table.setAccessibleName(tr("Residuals by element"))
        self.table.chosen.connect(self._fly)
        return self.table

    def _build_pose(self) -> QWidget:
        self.figures = QWidget()
        grid = QGridLayout(self.figures)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(0)
        self.pose: list[tuple[QLabel, QLabel, QLabel]] = []
        right, font = Qt.AlignmentFlag.AlignRight, fixed_width(self.font())
        tip = tr("Standard deviation, as the fit estimates it")
        for line in range(7):
            sd = make_label(name=f"fit_sd_{line}", font=font, tip=tip)
            labels = (make_label(font=font, faint=True), make_label(font=font), sd)
            for place, part in enumerate(labels):
                grid.addWidget(part, line, place, right if place else Qt.AlignmentFlag.AlignLeft)
            self.pose.append(labels)
        grid.setColumnStretch(0, 1)
        return self.figures

    def add_actions(self, live: QAction, save: QAction) -> None:
        """Offer switching on and off and saving as a box and a button."""
        self.on = box_of(live, "fit_on")
        words = tr("Save as the frame's camera")
        self.save = make_button(words, save.trigger, "fit_save", tip=save.toolTip(), wide=True)
        self._buttons.addWidget(self.on)
        self._buttons.addWidget(self.save)

    # --- showing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        services, live = self._services, self._services.live_fit
        self.model.setCurrentIndex(self.model.findData(live.model))
        insight = live.insight
        frame = services.state.frame.name if services.state.frame is not None else None
        came, self._frame = frame != self._frame, frame
        if insight is None and live.working and not came and self._shown is not None:
            if not self._slow.isActive():
                self._slow.start()  # what is shown turns grey if the fit takes long
            return
        self._slow.stop()
        self._shown = insight
        found = insight is not None and insight.fit.camera is not None
        self.save.setEnabled(found)
        if insight is None or not found:
            self._pages.explain(self._why_empty(insight))
            return
        self.content.setEnabled(True)
        self._show_fit(insight)
        self._pages.explain("")

    def _say_working(self) -> None:
        if self._services.live_fit.insight is None:
            self.content.setEnabled(False)
            self.save.setEnabled(False)
            show_note(self.chosen, tr("Fitting the clicks…"))

    def _why_empty(self, insight: FrameAnalysis | None) -> str:
        live = self._services.live_fit
        if live.problem:
            return as_sentence(live.problem)
        if insight is not None:
            return tr("No camera yet: {why}.", why=insight.fit.failure)
        return tr("Fitting the clicks…") if live.working else tr("No fit.")

    def _show_fit(self, insight: FrameAnalysis) -> None:
        services, fit = self._services, insight.fit
        known = services.source_frames.of(services.fit_source.source)
        _, score = self._opinion.of(known, insight.annotation, services.scorer)
        self.jac.setText("–" if score is None else f"{score.jac:.3f}")
        self.at_tau.setText(tr("JaC at {tau:.1f} px", tau=services.state.tau))
        show_note(self.counted, "" if score is None else _counted_words(score))
        self.mean.setText("–" if fit.mean_px is None else f"{fit.mean_px:.2f} px")
        left_open = ill_conditioned_reason(fit)
        weak = tr("<b>Hardly determined</b>: {what}", what=left_open) if left_open else ""
        show_note(self.weak, weak)
        show_note(self.chosen, _chosen_words(fit))
        camera = known.camera if known is not None else None
        ground_only = camera is not None and projects_only_ground(camera)
        terms = services.state.setup.describe(ground_only=ground_only)
        width, height = fit.size
        show_note(
            self.terms,
            tr(
                "JaC: {terms}; residuals: px of the picture, {width}x{height}",
                terms=terms,
                width=width,
                height=height,
            ),
        )
        self.rows.replace(fit_rows(fit, insight.annotation, services.scorer.frame_setup.field))
        self.table.show_chosen(services.state.selected_class)
        figures = pose_figures(fit)
        self.figures.setVisible(bool(figures))
        for labels, texts in zip(self.pose, figures, strict=False):  # none for a homography
            for part, text in zip(labels, texts, strict=True):
                part.setText(text)

    # --- choosing ------------------------------------------------------------------------------

    def _fly(self, at: int) -> None:
        services, row = self._services, self.rows.rows[at]
        polyline = services.state.annotation.get(row.class_name)
        if polyline is None or not polyline.points:
            return
        # While new clicks are fitted the rows are those of the clicks before.
        stays = row.point is not None and row.point < len(polyline.points)
        point = row.point if stays else None
        fly_to_point(services, services.state.annotation, row.class_name, point)


def _chosen_words(fit: FitResult) -> str:
    words = tr(MODELS.get(fit.model, fit.model))
    if fit.chosen_because is None:
        return words
    return tr("{model}. Chosen: {why}", model=words, why=fit.chosen_because)


def _counted_words(score: FrameScore) -> str:
    """Return what the JaC is made of: few elements in good order give a low one while most are
    missing."""
    every = Counter(ElementState(element.status) for element in score.elements)
    waiting = every.pop(ElementState.NOT_ANNOTATED, 0)
    passing, annotated = every[ElementState.PASSES], every.total()
    words = tr_count(
        annotated,
        "{passing} of {n:,} annotated element within {px:g} px",
        "{passing} of {n:,} annotated elements within {px:g} px",
        passing=passing,
        px=score.threshold,
    )
    if not waiting:
        return words
    return tr_count(
        waiting,
        "{counted}; {n} in sight not annotated yet",
        "{counted}; {n} in sight not annotated yet",
        counted=words,
    )
