"""The legend in the picture's corner: of what is there, out of the hand's way, switched off."""

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import SWITCHES, Settings
from tests.gui.conftest import Hand, until_kept


def texts(window: MainWindow) -> list[str]:
    return [entry.text for entry in window.canvas.legend.entries]


def test_it_explains_what_is_there(begun, qtbot):
    legend = begun.canvas.legend
    qtbot.waitUntil(lambda: "ghost: expected here" in texts(begun))
    assert texts(begun)[0] == "annotated, in its class's colour"
    assert legend.isVisible()
    assert "ghost: expected here" in legend.accessibleName()
    room = begun.canvas.viewport().rect()
    assert room.contains(legend.geometry())
    begun.actions_["ghosts"].trigger()
    qtbot.waitUntil(lambda: texts(begun) == ["annotated, in its class's colour"])
    begun.actions_["hide_overlays"].trigger()
    qtbot.waitUntil(lambda: not legend.isVisible())
    assert texts(begun) == []


def test_verdicts_and_sources_are_named(audited, qtbot):
    audited.services.camera_sources.set_active_camera(1)
    qtbot.waitUntil(lambda: texts(audited)[:2] == ["passes", "too far"])
    qtbot.waitUntil(lambda: {"projection", "true"} <= set(texts(audited)))
    audited.actions_["others"].trigger()
    qtbot.waitUntil(lambda: "true" not in texts(audited))
    audited.actions_["colour_origin"].trigger()
    qtbot.waitUntil(lambda: texts(audited)[0] == "from the file")


def test_it_gives_way_to_the_hand(begun, qtbot):
    legend, canvas = begun.canvas.legend, begun.canvas
    qtbot.waitUntil(lambda: "ghost: expected here" in texts(begun))
    hand = Hand(begun)
    assert legend.isVisible()
    at = canvas.to_picture(legend.geometry().center().toPointF())
    hand.move(*at)
    assert not legend.isVisible()
    hand.move(*canvas.to_picture(canvas.viewport().rect().center().toPointF()))
    assert legend.isVisible()


def test_it_can_be_switched_off_for_good(begun):
    begun.actions_["legend"].trigger()
    assert not begun.canvas.legend.isVisible()
    until_kept()
    begun.close()
    assert Settings().get(SWITCHES["legend"]) is False


def test_it_stands_above_what_is_said_of_the_camera(begun, qtbot):
    legend, plate = begun.canvas.legend, begun.canvas.found_plate
    qtbot.waitUntil(lambda: "ghost: expected here" in texts(begun))
    room, before = begun.canvas.viewport().rect(), legend.geometry()
    plate.put(room.adjusted(8, room.height() - 40, -8, -8))  # as wide as what it says may be
    plate.show()
    qtbot.waitUntil(lambda: legend.geometry().bottom() < plate.geometry().top())
    plate.hide()
    qtbot.waitUntil(lambda: legend.geometry() == before)
