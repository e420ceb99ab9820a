"""Titles in a column that is too narrow for them."""

import pytest
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QTableView

from procc_annotator.field.load import load_field
from procc_annotator.gui.panels.element_states import TitleDelegate, elided_title
from procc_annotator.gui.panels.scores import ELEMENT
from procc_annotator.gui.settings import take_up
from procc_annotator.translation import tr


def test_near_and_far_of_either_side_can_be_told_apart(qapp):
    titles = [f"{s} three-point {d} straight" for s in ("Left", "Right") for d in ("far", "near")]
    metrics = QFontMetrics(qapp.font())
    whole = metrics.horizontalAdvance(titles[-1])
    for width in range(metrics.horizontalAdvance("R… near straight "), whole + 1):
        shown = [elided_title(title, metrics, width) for title in titles]
        assert len(set(shown)) == 4
        assert all(metrics.horizontalAdvance(text) <= width for text in shown)
    assert elided_title(titles[-1], metrics, whole) == titles[-1]
    assert elided_title(titles[-1], metrics, whole - 1) == "Right … near straight"


@pytest.mark.parametrize("name", ["de", "es", "fr"])
def test_sides_can_be_told_apart_in_other_languages(qapp, name):
    metrics = QFontMetrics(qapp.font())
    width = metrics.horizontalAdvance("n" * 18)
    take_up(qapp, name)
    titles = {tr(element.title) for element in load_field("soccer").elements}
    shown = {elided_title(title, metrics, width) for title in titles}
    take_up(qapp, "en")
    assert len(shown) == len(titles)
    assert all(metrics.horizontalAdvance(text) <= width for text in shown)


def test_the_scores_use_them_and_say_the_whole_in_the_tip(audited):
    table = audited.findChild(QTableView, "scores_table")
    assert isinstance(table.itemDelegateForColumn(ELEMENT), TitleDelegate)
    audited.panels.show("scores")
    title = audited.services.state.field.title_of("Big rect. left main")
    tips = [table.model().index(r, 0).data(3) for r in range(table.model().rowCount())]
    assert any(tip.startswith(f"{title}\n") for tip in tips)
