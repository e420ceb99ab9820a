"""Nothing of the window is cut off where room is short: 1280x720, texts half as large again."""

from collections.abc import Iterator
from itertools import combinations

import pytest
from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtWidgets import QApplication, QTabBar, QWidget

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.elements import NAME
from procc_annotator.gui.settings import take_up
from procc_annotator.gui.window.tool_bar import IconButton
from tests.gui.conftest import Hand

pytestmark = [
    pytest.mark.new_window,
]


@pytest.fixture(params=[1.0, 1.5])
def text_size(request, qapp) -> Iterator[float]:
    usual = qapp.font()
    larger = qapp.font()
    larger.setPointSizeF(usual.pointSizeF() * request.param)
    qapp.setFont(larger)
    yield request.param
    qapp.setFont(usual)


def inside(widget: QWidget, window: MainWindow) -> bool:
    far = widget.mapTo(window, QPoint(widget.width(), widget.height()))
    return far.x() <= window.width() and far.y() <= window.height()


def test_everything_is_in_sight_at_1280x720(make_window, dataset, qtbot, text_size):
    window = make_window(dataset, size=(1280, 720))
    qtbot.waitUntil(lambda: window.docks["elements"].width() >= 200)
    assert window.size() == QSize(1280, 720)
    bar = window.top_bar
    buttons = window.side_bar.findChildren(IconButton)
    for widget in (bar.chip, bar.saved, bar.search, window.status, *buttons):
        assert widget.isVisible(), widget.objectName()
        assert inside(widget, window), widget.objectName()
    for desk, least in (("annotate", 0.65), ("judge", 0.45), ("review", 0.45)):
        window.panels.turn_to(desk)
        QApplication.processEvents()
        picture = window.canvas.size()
        if text_size == 1.0:
            assert picture.width() * picture.height() >= least * 1280 * 720
        for tabs in window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly):
            if tabs.isVisible():
                assert tabs.tabRect(tabs.count() - 1).right() <= tabs.width()


def test_the_class_under_the_pen_is_read(make_window, dataset, text_size, qtbot):
    window = make_window(dataset, size=(1280, 720))
    hand = Hand(window)
    window.services.selection.select_class("Goal left post left ")
    hand.click(100, 50)
    hint = window.status.hint
    qtbot.waitUntil(lambda: hint.text().startswith("DRAW Left goal"))
    shown = hint.text_for(hint.width())
    title = window.services.state.field.title_of("Goal left post left ")
    begin, _, end = shown.split("  •  ")[0].removeprefix("DRAW ").partition("…")
    assert title.startswith(begin.partition(", ")[0])
    assert not end or title.endswith(end)
    assert len(begin + end) >= 14
    hand.key(Qt.Key.Key_Escape)


@pytest.mark.parametrize("language", ["en", "de", "ja"])
def test_titles_of_elements_are_whole(make_window, dataset, qapp, qtbot, language):
    try:
        take_up(qapp, language)
        tree = make_window(dataset, size=(1280, 720)).elements.tree
        qtbot.waitUntil(lambda: tree.width() <= 280)
        QApplication.processEvents()
        groups = [tree.topLevelItem(i) for i in range(tree.topLevelItemCount())]
        items = [group.child(i) for group in groups for i in range(group.childCount())]
        assert len(items) > 30
        for item in items:
            row, title = tree.visualItemRect(item), item.text(NAME)
            room = tree.columnWidth(NAME) - tree.indentation() - tree.iconSize().width() - 10
            wrapped = tree.fontMetrics().boundingRect(
                QRect(0, 0, room, 0), Qt.TextFlag.TextWordWrap, title
            )
            assert wrapped.height() <= row.height(), title
            assert wrapped.width() <= room, title
    finally:
        take_up(qapp, "en")


def test_the_layout_goes_back_to_what_it_was_at_first(make_window, dataset, qtbot):
    window = make_window(dataset, size=(1280, 720))
    docks = window.docks
    qtbot.waitUntil(lambda: abs(docks["elements"].width() - 240) <= 40)

    def seen() -> dict[str, QSize]:
        QApplication.processEvents()
        return {n: d.size() for n, d in docks.items() if not d.visibleRegion().isEmpty()}

    before = seen()
    window.resizeDocks([docks["elements"]], [450], Qt.Orientation.Horizontal)
    window.panels.show("frames")
    window.panels.turn_to("judge")
    docks["scores"].setFloating(True)
    window.actions_["reset_layout"].trigger()
    assert seen() == before
    assert window.size() == QSize(1280, 720)


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_row_on_top_does_not_overlap(make_window, dataset, qapp, language):
    try:
        take_up(qapp, language)
        window = make_window(dataset, size=(1000, 720))
        QApplication.processEvents()
        for row in (window.menuWidget(), window.top_bar):
            direct = Qt.FindChildOption.FindDirectChildrenOnly
            parts = [p for p in row.findChildren(QWidget, options=direct) if p.isVisible()]
            assert len(parts) >= 3
            assert all(row.rect().contains(part.geometry()) for part in parts)
            for one, other in combinations(parts, 2):
                assert not one.geometry().intersects(other.geometry())
    finally:
        take_up(qapp, "en")
