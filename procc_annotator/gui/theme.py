"""Light and dark theme, following the system; icons, fonts, accessible roles of widgets."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QByteArray, QEvent, QObject, QRectF, Qt
from PySide6.QtGui import QAccessible, QColor, QFont, QGuiApplication, QPainter, QPalette
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import (
    QAccessibleWidget,
    QApplication,
    QGraphicsView,
    QLabel,
    QProxyStyle,
    QStyle,
    QStyleOptionViewItem,
    QWidget,
)

from procc_annotator.resources import resources_dir

_WHEN = (QEvent.Type.Show, QEvent.Type.FocusIn)


class _Role(QObject):
    """Reports what a widget is, when it is shown and whenever the keyboard comes to it.

    Qt keeps what is given by an object and its class, and the class becomes another one each time a
    method of Python is first connected: what was set before that is not read any more.
    """

    def __init__(self, widget: QWidget, role: QAccessible.Role) -> None:
        super().__init__(widget)
        self._widget, self._role = widget, role
        self._made: list[QAccessibleWidget] = []  # Qt deletes them with the widget
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in _WHEN and watched is self._widget:
            self._register()
        return False

    def _register(self) -> None:
        known = QAccessible.queryAccessibleInterface(self._widget)
        if known is None or known.role() != self._role:
            made = QAccessibleWidget(self._widget, self._role, "")
            QAccessible.registerAccessibleInterface(made)
            self._made.append(made)


def give_role(widget: QWidget, role: QAccessible.Role) -> None:
    """Have a widget exposed as something; its name and description are its own."""
    _Role(widget, role)


_BLACK = b"#000"  # what the files are drawn in


def paint_icon(painter: QPainter, name: str, box: QRectF, colour: QColor) -> None:
    """Paint an icon of ``resources/icons`` into a box, in one colour."""
    _drawn(name, colour.name()).render(painter, box)


@lru_cache(maxsize=128)  # every icon in the colours of both themes
def _drawn(name: str, colour: str) -> QSvgRenderer:
    """Raises `FileNotFoundError` where there is no such icon."""
    drawn = (resources_dir() / "icons" / f"{name}.svg").read_bytes()
    return QSvgRenderer(QByteArray(drawn.replace(_BLACK, colour.encode())))


_COLOURS = {  # light, dark
    QPalette.ColorRole.Window: ("#f3f4f5", "#24272a"),
    QPalette.ColorRole.WindowText: ("#1b1d1f", "#e6e8ea"),
    QPalette.ColorRole.Base: ("#ffffff", "#1a1c1e"),
    QPalette.ColorRole.AlternateBase: ("#f0f2f4", "#212427"),
    QPalette.ColorRole.Text: ("#1b1d1f", "#e6e8ea"),
    QPalette.ColorRole.PlaceholderText: ("#5a6168", "#9da5ad"),
    QPalette.ColorRole.Button: ("#e9ebed", "#33373b"),
    QPalette.ColorRole.ButtonText: ("#1b1d1f", "#e6e8ea"),
    QPalette.ColorRole.BrightText: ("#ffffff", "#ffffff"),
    QPalette.ColorRole.ToolTipBase: ("#ffffff", "#33373b"),
    QPalette.ColorRole.ToolTipText: ("#1b1d1f", "#e6e8ea"),
    QPalette.ColorRole.Highlight: ("#0b63a8", "#2873b2"),
    QPalette.ColorRole.HighlightedText: ("#ffffff", "#ffffff"),
    QPalette.ColorRole.Link: ("#0b63a8", "#6fb5ec"),
    QPalette.ColorRole.Light: ("#ffffff", "#4a4f54"),
    QPalette.ColorRole.Midlight: ("#e3e5e8", "#3c4145"),
    QPalette.ColorRole.Mid: ("#b9bec4", "#4a5056"),
    QPalette.ColorRole.Dark: ("#9aa0a6", "#141618"),
    QPalette.ColorRole.Shadow: ("#70757a", "#0a0b0c"),
}
# The style takes the edges of boxes that are ticked from the window's colour, a little darker: on a
# dark window no one sees them. These stand in for it, for what draws such boxes.
_WINDOW_OF_BOXES = {False: "#a6acb2", True: "#c0c6cc"}
WITH_BOXES = ("QCheckBox", "QRadioButton", "CommentList")
_TEXT_ROLES = (
    QPalette.ColorRole.WindowText,
    QPalette.ColorRole.Text,
    QPalette.ColorRole.ButtonText,
)
# (background, text) of lines that want attention; both pairs have a contrast above 7:1.
_ALARM = {False: ("#fde3d6", "#6b2200"), True: ("#5a2408", "#ffe3d3")}

LEAST_CONTRAST = 3.0  # of signs and lines against what is behind them (WCAG 2, 1.4.11)
_THEME, _USUAL_SIZE = "theme", "usualTextSize"  # properties of the application


def palette(dark: bool) -> QPalette:
    """The colours of the window, light or dark."""
    result = QPalette()
    for role, colours in _COLOURS.items():
        result.setColor(role, QColor(colours[dark]))
    for role in _TEXT_ROLES:
        result.setColor(
            QPalette.ColorGroup.Disabled, role, QColor("#7b838b" if dark else "#8b9299")
        )
    return result


def palette_of_boxes(dark: bool) -> QPalette:
    """The colours of what can be ticked, light or dark."""
    result = palette(dark)
    result.setColor(QPalette.ColorRole.Window, QColor(_WINDOW_OF_BOXES[dark]))
    return result


def wear(application: QApplication, dark: bool) -> None:
    """Give the application its colours."""
    application.setPalette(palette(dark))
    for kind in WITH_BOXES:
        # A text at run time, whatever the stub says.
        application.setPalette(palette_of_boxes(dark), kind)  # type: ignore[arg-type]


def is_dark(colours: QPalette) -> bool:
    """Return whether a palette is dark."""
    window = colours.color(QPalette.ColorRole.Window)
    return window.lightness() < colours.color(QPalette.ColorRole.WindowText).lightness()


def alarm_colours(colours: QPalette) -> tuple[str, str]:
    """(background, text) for a line that says something is wrong."""
    return _ALARM[is_dark(colours)]


class PlainTextStyle(QProxyStyle):
    """Shows the text of labels and tool tips as it is, unless a label asks for rich text.

    Names and texts of files may look like HTML; Qt would interpret them.
    """

    def polish(self, what: QWidget | QApplication | QPalette) -> None:  # type: ignore[override]
        super().polish(what)
        if isinstance(what, QLabel) and what.textFormat() == Qt.TextFormat.AutoText:
            what.setTextFormat(Qt.TextFormat.PlainText)


def follow_system(application: QApplication) -> None:
    """Give the application its looks now and whenever the system switches to light or dark."""
    application.setStyle(PlainTextStyle("Fusion"))  # not shown
    hints = QGuiApplication.styleHints()
    hints.colorSchemeChanged.connect(lambda _: set_theme(application, _theme(application)))
    set_theme(application, _theme(application))


def set_theme(application: QApplication, theme: str) -> None:
    """Wear the colours of a theme: "light", "dark", or "system" for those of the system."""
    application.setProperty(_THEME, theme)
    system = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
    dark = theme == "dark" or (theme == "system" and system)
    if dark != is_dark(application.palette()) or theme == "system":
        wear(application, dark)


def _theme(application: QApplication) -> str:
    return str(application.property(_THEME) or "system")


def set_text_size(application: QApplication, percent: float) -> None:
    """Have texts be so large, of what the system says."""
    font = application.font()
    usual = application.property(_USUAL_SIZE)
    if usual is None:
        usual = font.pointSizeF()
        application.setProperty(_USUAL_SIZE, usual)
    size = float(usual) * percent / 100
    if size > 0 and size != font.pointSizeF():  # one in pixels is the system's own affair
        font.setPointSizeF(size)
        application.setFont(font)
    text_times.cache_clear()


def running_application() -> QApplication:
    """Return the application that the window belongs to."""
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    return application


@lru_cache(maxsize=1)  # asked with every paint
def text_times() -> float:
    """Return how large texts are, of what the system says; 1 where no one chose."""
    application = QApplication.instance()
    usual = None if application is None else application.property(_USUAL_SIZE)
    size = QApplication.font().pointSizeF()
    return size / float(usual) if usual and float(usual) > 0 and size > 0 else 1.0


def fixed_width(widget_font: QFont, times: float = 1.0, *, bold: bool = False) -> QFont:
    """The same font, so many times as large, with digits of equal width, so that changing numbers
    do not jump."""
    font = QFont(widget_font)
    if times != 1.0:
        font.setPointSizeF(font.pointSizeF() * times)
    if bold:
        font.setBold(True)
    font.setStyleHint(QFont.StyleHint.SansSerif)
    font.setFeature(QFont.Tag("tnum"), 1)
    return font


def bold(font: QFont) -> QFont:
    """Return a font in bold."""
    made = QFont(font)
    made.setBold(True)
    return made


def blend(a: QColor, b: QColor, share: float) -> QColor:
    """A colour between two: share 0 gives the first, 1 the second."""
    return QColor.fromRgbF(
        a.redF() + (b.redF() - a.redF()) * share,
        a.greenF() + (b.greenF() - a.greenF()) * share,
        a.blueF() + (b.blueF() - a.blueF()) * share,
    )


def paint_row(painter: QPainter, option: QStyleOptionViewItem) -> tuple[QColor, QColor]:
    """Paint what is below a row of a list, chosen or with the mouse over it; the colours of that
    and of text on it."""
    palette: QPalette = option.palette
    base, text = palette.color(QPalette.ColorRole.Base), palette.color(QPalette.ColorRole.Text)
    if option.state & QStyle.StateFlag.State_Selected:
        base = palette.color(QPalette.ColorRole.Highlight)
        text = palette.color(QPalette.ColorRole.HighlightedText)
        painter.fillRect(option.rect, base)
    elif option.state & QStyle.StateFlag.State_MouseOver:
        base = blend(base, text, 0.07)
        painter.fillRect(option.rect, base)
    return base, text


def muted(palette: QPalette, share: float = 0.35) -> QColor:
    """Text that steps back, readable on light and on dark windows."""
    return blend(
        palette.color(QPalette.ColorRole.Text), palette.color(QPalette.ColorRole.Base), share
    )


def follow_theme(view: QGraphicsView) -> None:
    """Have a plot's ground painted in the theme of the moment; pyqtgraph's views keep the first."""
    view.setCacheMode(QGraphicsView.CacheModeFlag.CacheNone)


def readable(colour: str, palette: QPalette, least: float = LEAST_CONTRAST) -> QColor:
    """A colour as it is, or nearer to the text's where it would hardly be seen: below a contrast to
    the ground of lists and plots."""
    base = palette.color(QPalette.ColorRole.Base)
    text = palette.color(QPalette.ColorRole.Text)
    asked = QColor(colour)
    for share in range(20):
        tone = blend(asked, text, share / 20)
        if contrast(tone, base) >= least:
            return tone
    return text


def contrast(a: QColor, b: QColor) -> float:
    """The contrast ratio of two colours by WCAG 2, 1 to 21."""
    lighter, darker = sorted((_luminance(a), _luminance(b)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(colour: QColor) -> float:
    parts = (
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
        for c in (colour.redF(), colour.greenF(), colour.blueF())
    )
    return sum(share * part for share, part in zip((0.2126, 0.7152, 0.0722), parts, strict=True))
