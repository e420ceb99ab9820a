"""Field elements as every panel shows them: their state in this frame, symbols, short titles."""

from __future__ import annotations

from enum import Enum
from functools import lru_cache
from itertools import takewhile

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QIcon, QPainter, QPalette, QPen, QPixmap
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.field.model import Field
from procc_annotator.gui.panels.widgets import Index
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import is_dark, muted, readable
from procc_annotator.gui.theme import palette as theme_palette
from procc_annotator.interaction import palette as tones
from procc_annotator.translation import is_english, tr, word


class ElementState(Enum):
    """The state of one class in the frame on screen."""

    UNTOUCHED = "untouched"
    ANNOTATED = "annotated"
    UNCONFIRMED = "unconfirmed"
    PASSES = "tp"
    TOO_FAR = "too_far"
    NOT_ANNOTATED = "not_annotated"
    MISSED = "missed"
    NOT_VISIBLE = "not_visible"
    NEXT = "next"


_NOT_VISIBLE_DASH = (1.0, 4.0)
SIDE = 14  # logical px of a symbol in a row

WORDS = {
    ElementState.UNTOUCHED: "",
    ElementState.ANNOTATED: word("annotated"),
    ElementState.UNCONFIRMED: word("unconfirmed"),
    ElementState.NOT_VISIBLE: word("not visible"),
    ElementState.NEXT: word("next", "element"),
    **{ElementState(status): words for status, words in tones.STATUS_WORDS.items()},
}

EXPLANATIONS = {
    ElementState.UNTOUCHED: word("Not annotated in this frame"),
    ElementState.ANNOTATED: word(
        "Annotated, but not judged: no camera is shown, or it takes no part in the evaluation"
    ),
    ElementState.UNCONFIRMED: word("Copied; it does not count until it is touched or confirmed"),
    ElementState.PASSES: word("Passes: all its points are closer than tau to the projection"),
    ElementState.TOO_FAR: word("Too far: at least one point is tau or more away (false positive)"),
    ElementState.NOT_ANNOTATED: word(
        "The camera projects it, it is not annotated (false positive)"
    ),
    ElementState.MISSED: word("Annotated, the camera does not project it (false negative)"),
    ElementState.NOT_VISIBLE: word("Marked as not visible in this frame"),
    ElementState.NEXT: word("To be annotated next, as on the field map and in the picture"),
}


def words_for(state: ElementState) -> str:
    """Return what a state is called in the window; untouched elements are not spoken of."""
    about = "element" if state is ElementState.NEXT else ""
    return tr(WORDS[state], about) if WORDS[state] else ""


def element_states(services: Services) -> dict[str, ElementState]:
    """The state of every class that is annotated, projected or said to be not visible; all others
    are untouched.

    Classes bear the names the annotator gave, also where mirrored labels count.
    """
    states = dict.fromkeys(services.state.shown_annotation.annotated, ElementState.ANNOTATED)
    score = services.scorer.score
    if score is not None:
        for element in score.elements:
            states[element.annotated_name or element.name] = ElementState(element.status)
    for polyline in services.state.shown_annotation.unconfirmed:
        states[polyline.class_name] = ElementState.UNCONFIRMED
    frame = services.state.frame
    for name in services.review.not_visible(frame.name) if frame is not None else ():
        states.setdefault(name, ElementState.NOT_VISIBLE)
    return states


def fly_to_point(
    services: Services, annotation: FrameAnnotation, class_name: str, point: int | None
) -> bool:
    """Choose an element, or one of its points, and show the point (None: the first one). False if
    the annotation has no point of the element that can be shown."""
    if point is not None:
        services.selection.select_point(class_name, point)
    else:
        services.selection.select_class(class_name)
    polyline, size = annotation.get(class_name), services.state.picture_size
    if polyline is None or not polyline.points or size is None:
        return False
    x, y = points_px(polyline, size)[point or 0].tolist()
    services.store.events.flyTo.emit(x, y)
    return True


def class_title(field: Field, class_name: str) -> str:
    """Return what a class is called in the window."""
    title = field.title_of(class_name)
    return tr(title) if field.knows(class_name) else tr("{title} (unknown class)", title=title)


def class_colour(field: Field, class_name: str) -> QColor:
    """The swatch of a class; grey for classes without geometry."""
    element = field.element(class_name)
    return QColor(element.colour if element is not None else tones.UNKNOWN_CLASS)


def state_colour(state: ElementState, palette: QPalette) -> QColor:
    """The tone of a state, as far from the ground as a sign has to be; the neutral ones follow the
    theme."""
    unconfirmed = state is ElementState.UNCONFIRMED
    tone = tones.UNCONFIRMED if unconfirmed else tones.STATUS_COLOURS.get(state.value)
    if tone is not None:
        return QColor(_toned(tone, is_dark(palette)))
    strong = state in (ElementState.ANNOTATED, ElementState.NEXT)
    return muted(palette, 0.1 if strong else 0.4)


_LEAST = 3.6  # of contrast to the ground of lists; the field map's is a little darker


@lru_cache(maxsize=64)
def _toned(tone: str, dark: bool) -> QColor:
    return readable(tone, theme_palette(dark), _LEAST)


def state_pen(state: ElementState, palette: QPalette, width: float) -> QPen:
    """The line of a state: tone and dash pattern of the overlay."""
    return QPen(_pen(state, state_colour(state, palette).rgba(), width))


@lru_cache(maxsize=256)
def _pen(state: ElementState, rgba: int, width: float) -> QPen:
    pen = QPen(QColor.fromRgba(rgba), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    unconfirmed = state is ElementState.UNCONFIRMED
    dash = tones.UNCONFIRMED_DASH if unconfirmed else tones.STATUS_DASHES.get(state.value, ())
    if state is ElementState.NOT_VISIBLE:
        dash = _NOT_VISIBLE_DASH
    if state is ElementState.NEXT:
        dash = tones.GHOST_DASH
    if dash:
        pen.setDashPattern([d / width for d in dash])
    return pen


def symbol_icon(state: ElementState, view: QWidget) -> QIcon:
    """The symbol of a state for the rows of a view; in a selected row it takes its text's colour,
    which its shape allows.
    """
    palette = view.palette()
    on_highlight = palette.color(QPalette.ColorRole.HighlightedText)
    colours = state_colour(state, palette).rgba(), on_highlight.rgba()
    return _symbol_icon(state, *colours, view.devicePixelRatioF())


@lru_cache(maxsize=256)
def _symbol_icon(state: ElementState, usual: int, selected: int, dpr: float) -> QIcon:
    icon = QIcon()
    for colour, mode in ((usual, QIcon.Mode.Normal), (selected, QIcon.Mode.Selected)):
        pixmap = QPixmap(round(SIDE * dpr), round(SIDE * dpr))
        pixmap.setDevicePixelRatio(dpr)
        pixmap.fill(Qt.GlobalColor.transparent)
        painter = QPainter(pixmap)
        paint_symbol(painter, QRectF(0, 0, SIDE, SIDE), state, QColor.fromRgba(colour))
        painter.end()
        icon.addPixmap(pixmap, mode)
    return icon


def paint_symbol(painter: QPainter, rect: QRectF, state: ElementState, colour: QColor) -> None:
    """Draw the sign of a state: tick, cross, dashed ring, dots; a dash; distinguished without
    colour."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    side = min(rect.width(), rect.height())
    centre = rect.center()
    pen = QPen(colour, side * 0.14)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    painter.setPen(pen)
    arm = side * 0.3
    if state is ElementState.PASSES:
        painter.drawPolyline(
            [
                centre + QPointF(-arm, 0),
                centre + QPointF(-arm * 0.25, arm * 0.8),
                centre + QPointF(arm, -arm * 0.9),
            ]
        )
    elif state is ElementState.TOO_FAR:
        painter.drawLine(QLineF(centre - QPointF(arm, arm), centre + QPointF(arm, arm)))
        painter.drawLine(QLineF(centre - QPointF(arm, -arm), centre + QPointF(arm, -arm)))
    elif state is ElementState.NOT_ANNOTATED:
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setDashPattern([2.0, 1.36])  # four dashes around
        painter.setPen(pen)
        painter.drawEllipse(centre, arm * 1.02, arm * 1.02)
    elif state is ElementState.MISSED:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        for step in (-1, 0, 1):
            painter.drawEllipse(centre + QPointF(step * arm * 1.1, 0), side * 0.11, side * 0.11)
    elif state is ElementState.UNCONFIRMED:
        painter.drawEllipse(centre, arm * 0.8, arm * 0.8)
    elif state is ElementState.NEXT:
        painter.drawPolyline(
            [centre + QPointF(-arm * 0.5, arm * k) for k in (-1, 1)]
            + [centre + QPointF(arm * 0.8, 0), centre + QPointF(-arm * 0.5, -arm)]
        )
    elif state is ElementState.NOT_VISIBLE:
        painter.drawLine(QLineF(centre - QPointF(arm, 0), centre + QPointF(arm, 0)))
    elif state is ElementState.ANNOTATED:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawEllipse(centre, arm * 0.7, arm * 0.7)
    painter.restore()


def class_swatch(field: Field, class_name: str) -> QIcon:
    """A small square in the colour of a class, the same in a selected row."""
    return _swatch(class_colour(field, class_name).rgba())


@lru_cache(maxsize=512)
def _swatch(rgba: int) -> QIcon:
    pixmap = QPixmap(32, 32)
    pixmap.setDevicePixelRatio(2)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QColor(0, 0, 0, 90))
    painter.setBrush(QColor.fromRgba(rgba))
    painter.drawRoundedRect(QRectF(2.5, 2.5, 11, 11), 2.5, 2.5)
    painter.end()
    icon = QIcon(pixmap)
    for mode in (QIcon.Mode.Selected, QIcon.Mode.Active):
        icon.addPixmap(pixmap, mode)  # or the style would tint it
    return icon


_COMMAS = (",", "、", "，")


def short_titles(field: Field) -> dict[str, str]:
    """By class: the title without what its group says already.

    In English these are the leading words that all titles of the group share with it: below "Left
    three-point line" the "Left three-point far straight" is the "Far straight". Other languages
    bend their words and put them elsewhere; there it is a first part of words of the group: below
    "Linkes Tor" the "Linkes Tor, linker Pfosten" is the "Linker Pfosten".
    """
    groups: dict[str, list[tuple[str, str]]] = {}
    for element in field.elements:
        groups.setdefault(element.group, []).append((element.name, element.title))
    found = {}
    for group, elements in groups.items():
        leading = _leading(group, [title for _, title in elements])
        for name, title in elements:
            said, english = tr(title), " ".join(title.split()[leading:])
            rest = english if said == title else _beyond(tr(group), said)
            found[name] = f"{rest[:1].upper()}{rest[1:]}"
    return found


def _beyond(group: str, title: str) -> str:
    """Return what a title says behind a first part that has no word but the group's; else all of
    it."""
    for comma in _COMMAS:
        first, _, rest = title.partition(comma)
        if rest and set(first.split()) <= set(group.split()):
            return rest.strip()
    return title


def _leading(group: str, titles: list[str]) -> int:
    """Return how many leading words of a group all its titles share, each having words beyond
    them."""
    if len(titles) < 2:
        return 0
    columns = zip(group.split(), *(title.split()[:-1] for title in titles), strict=False)
    return sum(1 for _ in takewhile(lambda words: len(set(words)) == 1, columns))


class TitleDelegate(QStyledItemDelegate):
    """Writes titles so that near and far, left and right can be distinguished."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        view = option.widget
        style = view.style()
        room = style.subElementRect(QStyle.SubElement.SE_ItemViewItemText, option, view).width()
        margin = style.pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, view) + 1
        option.text = elided_title(option.text, option.fontMetrics, room - 2 * margin)


def elided_title(title: str, metrics: QFontMetrics, width: int) -> str:
    """A title in so many px: the side of the field stands first, what distinguishes its parts last.

    "Right three-point far straight" becomes "Right … far straight", then "R… far straight". Other
    languages have the side anywhere: there every long word is shortened.
    """
    if not is_english():
        return _abbreviated(title, metrics, width)
    words = title.split()
    fewer = (words[1 + left_out :] for left_out in range(1, len(words) - 2))
    shorter = [title, *(" ".join((words[0], "…", *rest)) for rest in fewer)]
    if len(words) > 2:
        shorter.append(" ".join((f"{words[0][0]}…", *words[-2:])))
    for text in shorter:
        if metrics.horizontalAdvance(text) <= width:
            return text
    return metrics.elidedText(title, Qt.TextElideMode.ElideMiddle, max(width, 0))


def _abbreviated(title: str, metrics: QFontMetrics, width: int) -> str:
    """Shorten the longest words of a title first: "Surf. gauc. côté loin."."""
    words = title.split()
    for most in range(max(map(len, words), default=0), 1, -1):
        text = " ".join(w if len(w) <= most else f"{w[: most - 1]}." for w in words)
        if metrics.horizontalAdvance(text) <= width:
            return text
    return metrics.elidedText(title, Qt.TextElideMode.ElideMiddle, max(width, 0))
