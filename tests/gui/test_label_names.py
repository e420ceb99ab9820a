"""Importing annotations whose labels are no classes: what they stand for is asked, and kept."""

import json
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox
from pytestqt.qtbot import QtBot

from procc_annotator.gui.commands.exchange_dialogs import LabelDialog
from procc_annotator.gui.commands.importing import AnnotationImporter


def shape(label: str, *points: tuple[float, float]) -> dict[str, object]:
    return {"label": label, "points": [list(p) for p in points], "shape_type": "linestrip"}


@pytest.fixture
def foreign(tmp_path) -> Path:
    folder = tmp_path / "foreign"
    folder.mkdir()
    for i in range(3):
        shapes = [
            shape("halfway-line", (300, 10), (300, 300)),
            shape("goal line", (620, 10), (600, 300)),
            shape("goal line", (10, 10), (20, 300)),
            shape("crowd", (0, 0), (600, 5)),
            shape("odd", (0, 0), (600, 5)),
        ]
        content = {"shapes": shapes, "imageWidth": 640, "imageHeight": 360}
        (folder / f"frame_{i}.json").write_text(json.dumps(content))
    return folder


@pytest.fixture
def importer(services, widget) -> AnnotationImporter:
    widget.show()
    return AnnotationImporter(services, widget)


def asked(importer: AnnotationImporter, qtbot: QtBot, path: Path) -> LabelDialog:
    """The dialog of names, once the annotations are read."""
    importer.names = None
    importer.ask()
    dialog = importer.dialog
    dialog.path.setText(str(path))
    dialog.start_button.click()
    qtbot.waitUntil(lambda: importer.names is not None)
    names = importer.names
    assert names is not None
    return names


def told(importer: AnnotationImporter, qtbot: QtBot) -> str:
    dialog = importer.dialog
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()) and not dialog.bar.isVisible())
    return dialog.report.toPlainText()


def choose(names: LabelDialog, label: str, text: str) -> None:
    box = next(b for b in names.choices if b.accessibleName() == f"What {label} stands for")
    box.setCurrentIndex(next(i for i in range(box.count()) if box.itemText(i).startswith(text)))


def box_of(names: LabelDialog, label: str) -> QComboBox:
    return next(b for b in names.choices if b.accessibleName() == f"What {label} stands for")


def test_labels_are_asked_for_and_kept_with_the_dataset(
    services, importer, qtbot, dataset, foreign
):
    names = asked(importer, qtbot, foreign)
    assert box_of(names, "halfway-line").currentText() == "Halfway line"  # by its words
    assert box_of(names, "crowd").currentText().startswith("?")  # nothing is guessed
    choose(names, "crowd", "Leave out")
    choose(names, "goal line", "Left goal line, Right goal line (left to right)")
    names.take.click()
    assert "3 of 3 frames imported" in told(importer, qtbot)
    services.saver.settle()
    content = json.loads((dataset / "frame_0.json").read_text())
    assert set(content) == {"Middle line", "Side line left", "Side line right", "odd"}
    assert content["Side line left"][0]["x"] == 10 / 639
    text = (dataset / "labels.toml").read_text()
    assert '"crowd" = false' in text
    assert '"goal line" = { left_to_right = ["Side line left", "Side line right"] }' in text
    assert '"odd"' not in text


def test_names_that_are_kept_are_not_asked_for_again(services, importer, qtbot, dataset, foreign):
    rules = [
        '"halfway-line" = "Middle line"', '"goal line" = false', "crowd = false", "odd = false"
    ]  # fmt: skip
    (dataset / "labels.toml").write_text("\n".join(["[labels]", *rules]))
    importer.ask()
    dialog = importer.dialog
    dialog.path.setText(str(foreign))
    dialog.start_button.click()
    assert "3 of 3 frames imported" in told(importer, qtbot)
    services.saver.settle()
    assert set(json.loads((dataset / "frame_1.json").read_text())) == {"Middle line"}


def test_cancelling_imports_nothing(importer, qtbot, dataset, foreign):
    names = asked(importer, qtbot, foreign)
    QTest.keyClick(names, Qt.Key.Key_Escape)
    assert "nothing was imported" in told(importer, qtbot)
    assert not (dataset / "frame_0.json").exists()
    assert not (dataset / "labels.toml").exists()


def test_the_dialog_is_worked_by_keys(importer, qtbot, foreign):
    names = asked(importer, qtbot, foreign)
    qtbot.waitUntil(names.isVisible)
    first = names.choices[0]
    first.setFocus()
    before = first.currentIndex()
    QTest.keyClick(first, Qt.Key.Key_Down)
    assert first.currentIndex() == before + 1
    order = [first]
    while len(order) < len(names.choices):
        order.append(order[-1].nextInFocusChain())
        while not isinstance(order[-1], QComboBox):
            order[-1] = order[-1].nextInFocusChain()
    assert order == names.choices
    QTest.keyClick(names, Qt.Key.Key_Return)
    assert "imported" in told(importer, qtbot)
