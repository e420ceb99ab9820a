"""The dialog of settings: everything in it can be found, changed, and put back."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.gui import settings as rows
from procc_annotator.gui.settings import OFFERED, Settings
from procc_annotator.gui.theme import is_dark, set_theme
from procc_annotator.gui.window.window_settings import SettingRow, SettingsDialog


@pytest.fixture
def dialog(window) -> Iterator[SettingsDialog]:
    application = QApplication.instance()
    before = application.palette()
    window.actions_["settings"].trigger()
    found = window.findChild(SettingsDialog)
    yield found
    found.close()
    set_theme(application, "system")
    application.setPalette(before)


def row(dialog: SettingsDialog, key: str) -> SettingRow:
    return next(r for r in dialog.rows if r.setting.key == key)


def test_what_is_changed_holds_at_once_and_is_remembered(window, dialog):
    box = row(dialog, "tau").editor
    box.setFocus()
    box.selectAll()
    QTest.keyClicks(box, "12,5")
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert window.services.state.tau == 12.5
    assert Settings().get(rows.TAU) == 12.5

    snapping = row(dialog, "snapping").editor
    snapping.setFocus()
    QTest.keyClick(snapping, Qt.Key.Key_Space)
    assert not window.services.state.options.snapping
    assert not window.actions_["snapping"].isChecked()

    protocol = row(dialog, "protocol").editor
    QTest.keyClick(protocol, Qt.Key.Key_Down)
    assert window.services.state.setup.protocol == "procc"
    assert window.actions_["protocol_procc"].isChecked()

    share = row(dialog, "ghost_support").editor
    share.stepUp()
    assert Settings().get(rows.GHOST_SUPPORT) == pytest.approx(rows.GHOST_SUPPORT.default + 0.05)
    assert window.ghost_tasks.accepting.least_support == Settings().get(rows.GHOST_SUPPORT)


def test_a_setting_goes_back_to_its_default_and_all_do(window, dialog):
    window.services.evaluation.set_tau(9)
    window.actions_["pinned"].trigger()
    window.actions_["off_plane_left_out"].trigger()
    dialog.refresh()
    changed = {r.setting.key for r in dialog.rows if r.back.isEnabled()}
    assert changed == {"tau", "pinned", "off_plane"}
    QTest.mouseClick(row(dialog, "tau").back, Qt.MouseButton.LeftButton)
    assert window.services.state.tau == rows.TAU.default
    assert not row(dialog, "tau").back.isEnabled()
    QTest.mouseClick(dialog.all_back, Qt.MouseButton.LeftButton)
    assert window.services.state.options.pinned
    assert window.services.state.setup.off_plane == "missed"
    assert not any(r.back.isEnabled() for r in dialog.rows)


def test_the_theme_is_worn_at_once(dialog, qapp, qtbot):
    combo = row(dialog, "theme").editor
    combo.setCurrentIndex(combo.findData("light"))
    combo.activated.emit(combo.currentIndex())
    assert not is_dark(qapp.palette())
    QTest.keyClick(combo, Qt.Key.Key_Down)
    assert combo.currentData() == "dark"
    assert is_dark(qapp.palette())
    qtbot.waitUntil(lambda: QColor(dialog.grab().toImage().pixelColor(3, 3)).lightness() < 128)
    assert Settings().get(rows.THEME) == "dark"


def test_every_setting_is_found_by_its_words_alone(dialog):
    for setting in OFFERED:
        dialog.search.setText(setting.shown.title)
        shown = [r.setting.key for r in dialog.rows if not r.isHidden()]
        assert setting.key in shown, setting.key
        assert len(shown) < len(OFFERED) / 2
    dialog.search.setText("no such thing at all")
    assert all(r.isHidden() for r in dialog.rows)
    assert dialog._pages.empty.isVisible()


def test_every_setting_is_in_the_palette(window, qtbot):
    for setting in OFFERED:
        found = window.palette_._found(setting.shown.title, ())
        keys = {f"setting:{setting.key}", f"action:{setting.key}"}
        assert keys & {entry.key for entry in found[:4]}, setting.key
    entry = window.palette_._found("text size", ())[0]
    entry.run()
    dialog = window.findChild(SettingsDialog)
    qtbot.waitUntil(lambda: QApplication.focusWidget() is row(dialog, "font_percent").editor)
    seen = row(dialog, "font_percent").visibleRegion().boundingRect()
    assert seen.height() == row(dialog, "font_percent").height()
    dialog.close()


def test_a_name_of_ones_own_can_be_given_and_taken_back(window, dialog):
    before = window.services.state.author
    line = row(dialog, "author").editor
    line.setFocus()
    QTest.keyClicks(line, "Ada")
    QTest.keyClick(line, Qt.Key.Key_Return)
    assert window.services.state.author == "Ada"
    QTest.mouseClick(row(dialog, "author").back, Qt.MouseButton.LeftButton)
    assert window.services.state.author == before


@pytest.mark.new_window
def test_texts_half_as_large_again_come_with_the_next_start_and_fit(make_window, qapp):
    usual = qapp.font()
    settings = Settings()
    settings.set(rows.FONT_PERCENT, 150.0)
    try:
        window = make_window()
        assert window.font().pointSizeF() == pytest.approx(1.5 * usual.pointSizeF())
        assert window.width() <= 1280
        assert window.height() <= 720
        assert window.status.y() + window.status.height() <= 720
        window.actions_["settings"].trigger()
        dialog = window.findChild(SettingsDialog)
        for r in dialog.rows:
            assert r.editor.width() >= r.editor.minimumSizeHint().width()
            assert r.width() <= dialog._area.viewport().width()
    finally:
        qapp.setFont(usual)
