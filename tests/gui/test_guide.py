"""The user guide opens in the window, with its pages and headings, without a network."""

from PySide6.QtCore import QUrl
from PySide6.QtTest import QTest

from procc_annotator.gui.window.commands import Guide


def test_help_opens_the_guide(window):
    window.actions_["guide"].trigger()
    guide = window.findChild(Guide, "guide")
    assert guide.isVisible()
    headings = [guide.headings.item(i).text().strip() for i in range(guide.headings.count())]
    assert headings == ["User guide", "Tutorials", "How-to", "Reference", "Explanation"]
    guide.headings.itemClicked.emit(guide.headings.item(headings.index("Reference")))
    assert guide.page.textCursor().block().text() == "Reference"
    guide.page.anchorClicked.emit(QUrl("explanation/uncertainty.md"))
    guide.page.anchorClicked.emit(QUrl("fitting.md#models"))
    assert guide.page_name == "explanation/fitting.md"
    assert guide.page.textCursor().block().text() == "Models"
    guide.page.anchorClicked.emit(QUrl("../../README.md"))  # not of the guide
    assert guide.page_name == "explanation/fitting.md"
    QTest.keyClicks(guide.search, "evidence")
    guide.search.returnPressed.emit()
    assert guide.page.textCursor().selectedText().lower() == "evidence"
    guide.close()
