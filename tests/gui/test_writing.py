"""Asking where something of the dataset is written to."""

import pytest
from PySide6.QtWidgets import QFileDialog, QWidget

from procc_annotator.gui.messages import ask_where
from procc_annotator.gui.state.services import Services

TABLE, JSON = "Table (*.csv)", "JSON (*.json)"


@pytest.mark.parametrize(
    ("kinds", "typed", "kind", "expected"),
    [
        (TABLE, "x", TABLE, "x.csv"),
        (TABLE, "x", "", "x.csv"),  # not every system's dialog says which kind it was
        (TABLE, "x.txt", TABLE, "x.txt"),
        (f"{TABLE};;{JSON}", "x", JSON, "x.json"),
        ("Zip archive (*.zip);;Folder (*)", "x", "Folder (*)", "x"),
    ],
)
def test_a_name_without_a_suffix_gets_that_of_its_kind(
    dataset, qtbot, monkeypatch, kinds, typed, kind, expected
):
    asked: list[str] = []

    def ask(parent: QWidget, title: str, start: str, filters: str) -> tuple[str, str]:
        asked.extend((title, start, filters))
        return str(dataset / typed), kind

    monkeypatch.setattr(QFileDialog, "getSaveFileName", ask)
    parent = QWidget()
    qtbot.addWidget(parent)
    services = Services(parent=parent)
    assert services.opening.open_path(dataset)
    assert ask_where(services, parent, "Export", "name.csv", kinds) == dataset / expected
    assert asked == ["Export", str(dataset.parent / "name.csv"), kinds]
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: ("", ""))
    assert ask_where(services, parent, "Export", "name.csv", kinds) is None
    services.close()


def test_nothing_is_asked_where_nothing_is_open(qtbot, monkeypatch):
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: pytest.fail("asked"))
    parent = QWidget()
    qtbot.addWidget(parent)
    services, said = Services(parent=parent), []
    services.store.events.message.connect(lambda m: said.append((m.text, m.level)))
    assert ask_where(services, parent, "Export", "name.csv", TABLE) is None
    assert said == [("open a folder of pictures first", "warning")]
    services.close()
