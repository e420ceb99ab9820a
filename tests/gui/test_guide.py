"""The user guide opens in the window, with its pages and headings, without a network."""

from PySide6.QtCore import QUrl
from PySide6.QtTest import QTest

from procc_annotator.gui.window.commands import Guide


def test_help_opens_the_guide(window):
    window.actions_["guide"].trigger()
    guide = window.findChild(Guide, "guide")
    assert guide.isVisible()
    headings = [guide.headings.item(i).text().strip() for i in range(guide.headings.count())]
    assert "Videos" in headings
    guide.headings.itemClicked.emit(guide.headings.item(headings.index("Videos")))
    assert guide.page.textCursor().block().text() == "Videos"
    guide.page.anchorClicked.emit(QUrl("fitting.md"))
    assert guide.page_name == "fitting.md"
    guide.page.anchorClicked.emit(QUrl("../README.md"))  # not of the guide
    assert guide.page_name == "fitting.md"
    QTest.keyClicks(guide.search, "covariance")
    guide.search.returnPressed.emit()
    assert guide.page.textCursor().selectedText().lower() == "covariance"
    guide.close()
