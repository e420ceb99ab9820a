"""Taking a plot along: as a picture or as numbers, to the clipboard or a file."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QRectF, QSizeF, Qt
from PySide6.QtGui import (
    QFont,
    QFontMetricsF,
    QGuiApplication,
    QImage,
    QImageWriter,
    QPainter,
    QPalette,
)

from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.messages import ask_where, write
from procc_annotator.gui.panels.plots.page import Legend, PlotPage, PlotRequest
from procc_annotator.gui.panels.widgets import Panel
from procc_annotator.gui.state.background import run_in_background
from procc_annotator.gui.state.services import Services
from procc_annotator.report.tables.data_files import CRLF, csv_bytes
from procc_annotator.report.window_tables import plot_table
from procc_annotator.translation import tr, tr_count

SHARPNESS = 3.0  # pixels of a picture for every pixel of the window, whatever its scale
_MARGIN = 10.0


class PlotPicture:
    """A page, with something drawn, with its title, its legend (of the sources) and what is said of
    it (title and subtitle, and the notes below), on anything that can be painted."""

    def __init__(self, page: PlotPage[Any], legend: Legend, words: tuple[str, str, str]) -> None:
        self._page, self._legend = page, legend
        self._title, self._subtitle, self._notes = words
        view = page.view.size()
        self._width = float(view.width())
        metrics = QFontMetricsF(page.font())
        self._line = metrics.height()
        self._title_height = 2.6 * self._line if self._subtitle else 1.5 * self._line
        self._legend_height = float(legend.heightForWidth(round(self._width)))
        bounds = metrics.boundingRect(
            QRectF(0, 0, self._width, 10_000), int(Qt.TextFlag.TextWordWrap), self._notes or " "
        )
        self._notes_height = bounds.height() + 4 if self._notes else 0.0
        height = self._title_height + self._legend_height + 6 + view.height() + self._notes_height
        self.size = QSizeF(self._width + 2 * _MARGIN, height + 2 * _MARGIN)

    def paint(self, painter: QPainter) -> None:
        """Paint it at the painter's origin, `size` large."""
        palette = self._page.palette()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(QRectF(0, 0, self.size.width(), self.size.height()), palette.base())
        text = palette.color(QPalette.ColorRole.Text)
        painter.setPen(text)
        bold = QFont(self._page.font())
        bold.setBold(True)
        painter.setFont(bold)
        top = _MARGIN
        left = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        painter.drawText(QRectF(_MARGIN, top, self._width, self._line), left, self._title)
        painter.setFont(self._page.font())
        if self._subtitle:
            second = QRectF(_MARGIN, top + 1.2 * self._line, self._width, self._line)
            painter.drawText(second, left, self._subtitle)
        top += self._title_height
        painter.save()
        painter.translate(_MARGIN, top)
        self._legend.paint(painter, self._width)
        painter.restore()
        top += self._legend_height + 6
        view = self._page.view
        place = QRectF(_MARGIN, top, self._width, view.height())
        view.render(painter, place, view.rect())
        top += view.height()
        if self._notes:
            painter.setPen(text)
            painter.setFont(self._page.font())
            notes = QRectF(_MARGIN, top + 4, self._width, self._notes_height)
            painter.drawText(notes, int(Qt.TextFlag.TextWordWrap), self._notes)

    def image(self) -> QImage:
        """As pixels, sharp enough to print."""
        size = (self.size * SHARPNESS).toSize()
        image = QImage(size, QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(SHARPNESS)  # so that lines and dots grow with it
        image.fill(self._page.palette().color(QPalette.ColorRole.Base))
        painter = QPainter(image)
        self.paint(painter)
        painter.end()
        image.setDotsPerMeterX(round(96 * SHARPNESS / 0.0254))
        image.setDotsPerMeterY(round(96 * SHARPNESS / 0.0254))
        return image

    def svg(self) -> bytes:
        """As an SVG file's bytes."""
        from PySide6.QtSvg import QSvgGenerator  # only here: opening a window needs no SVG

        held = QByteArray()
        buffer = QBuffer(held)
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        generator = QSvgGenerator()
        generator.setOutputDevice(buffer)
        generator.setTitle(self._title)
        generator.setSize(self.size.toSize())
        generator.setViewBox(QRectF(0, 0, self.size.width(), self.size.height()))
        painter = QPainter(generator)
        self.paint(painter)
        painter.end()
        return bytes(held.data())


def picture_writer(picture: PlotPicture, path: Path) -> Callable[[], bytes]:
    """Return what gives the bytes of a file of this name, SVG or PNG, from any thread.

    Call this itself on the interface thread: only there plots can be painted.
    """
    if path.suffix.lower() == ".svg":
        content = picture.svg()
        return lambda: content
    image = picture.image()
    return lambda: _png(image)


def _png(image: QImage) -> bytes:
    held = QByteArray()
    buffer = QBuffer(held)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, QByteArray(b"png")).write(image)
    return bytes(held.data())


class ExportablePlot(Panel):
    """A panel with one plot on show, which can be copied and saved."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "plots_panel", (300, 360))
        self.legend = Legend()
        # What is drawn, and what there is to say of it; None until something of this page is.
        self._data: Any = None
        self._request: PlotRequest | None = None
        self._said = ""

    @property
    @abstractmethod
    def page(self) -> PlotPage[Any]:
        """The plot on show."""

    def copy_picture(self) -> None:
        """Put the plot on the clipboard as a picture."""
        if (picture := self._picture()) is not None:
            with self._drawn_sharp(SHARPNESS):
                image = picture.image()
            QGuiApplication.clipboard().setImage(image)
            self._services.say(tr("the plot is on the clipboard as a picture"))

    def copy_numbers(self) -> None:
        """Put the plotted numbers on the clipboard as CSV."""
        self._numbers(self._put_text)

    def ask_picture(self) -> None:
        """Ask for a file and write the plot there."""
        path = self._ask("png", tr("Picture (*.png);;Vector graphics (*.svg)"))
        if path is not None:
            self.save_picture(path)

    def ask_numbers(self) -> None:
        """Ask for a file and write the plotted numbers there."""
        path = self._ask("csv", tr("Table (*.csv)"))
        if path is not None:
            self.save_numbers(path)

    def save_picture(self, path: Path) -> None:
        """Write the plot as .png or .svg."""
        if (picture := self._picture()) is not None:
            with self._drawn_sharp(1.0 if path.suffix.lower() == ".svg" else SHARPNESS):
                content = picture_writer(picture, path)
            self._write(path, content)

    def save_numbers(self, path: Path) -> None:
        """Write the plotted numbers as CSV."""
        self._numbers(lambda text: self._write(path, text.encode))

    @property
    def _unfinished(self) -> bool:
        request = self._request
        of_set = request is not None and request.scope == "set"
        return of_set and self._services.scoring.running

    def _numbers(self, use: Callable[[str], None]) -> None:
        page, data, request = self.page, self._data, self._request
        if request is None or page.is_empty:
            self._services.say(tr("there is nothing plotted to take along"))
            return
        run_in_background(
            lambda _: csv_bytes(plot_table(page.table(data, request)), line_end=CRLF).decode(),
            on_result=use,
            on_error=lambda text: self._services.say(text, "error"),
            owner=self,
        )

    def _put_text(self, text: str) -> None:
        QGuiApplication.clipboard().setText(text)
        self._services.say(tr("the plotted numbers are on the clipboard"))

    def _picture(self) -> PlotPicture | None:
        page, request = self.page, self._request
        if request is None or page.is_empty:
            self._services.say(tr("there is nothing plotted to take along"))
            return None
        if request.scope == "frame":
            what = request.frames[request.current]
        else:
            what = tr_count(len(request.frames), "{n:,} frame", "{n:,} frames")
            if self._unfinished:
                what = tr("{frames}, as far as scored", frames=what)
        if request.class_row is not None:
            what += f", {tr(request.titles[request.class_row])}"
        terms = f"{what}; {self._services.state.setup.describe()}"
        return PlotPicture(page, self.legend, (tr(page.title), terms, self._said))

    @contextmanager
    def _drawn_sharp(self, sharpness: float) -> Iterator[None]:
        """The plot with lines as wide as a picture needs them."""
        page, data, request = self.page, self._data, self._request
        if request is None:
            return
        try:
            page.sharpness = sharpness
            page.draw(data, request)
            yield
        finally:
            page.sharpness = None
            page.draw(data, request)

    def _ask(self, suffix: str, filters: str) -> Path | None:
        if self._services.state.frame is None or self._request is None:
            self._services.say(tr("there is nothing plotted to take along"))
            return None
        words = "".join(c for c in self.page.title.lower() if c.isalnum() or c == " ")
        name = f"{words.replace(' ', '_')}.{suffix}"
        return ask_where(self._services, self, tr("Save the plot"), name, filters)

    def _write(self, path: Path, content: Callable[[], bytes]) -> None:
        said = tr("wrote {path}, as far as scored") if self._unfinished else tr("wrote {path}")
        write(
            self._services,
            lambda _: write_atomic(path, content()),
            lambda _: said.format(path=path),
            owner=self,
        )
