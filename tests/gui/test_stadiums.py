"""In the window each frame of a set of several stadiums has the dimensions of its own."""

from pathlib import Path

from pytestqt.qtbot import QtBot

from procc_annotator.field.load import load_field
from procc_annotator.gui.main_window import MainWindow


def length(window: MainWindow) -> float:
    found = window.services.scorer.frame_setup.field.dimension("length")
    return found.value


def judged_at(window: MainWindow, folder: Path, frame: int, qtbot: QtBot) -> float:
    assert window.services.camera_sources.load_cameras(folder / "cameras" / "true")
    window.services.navigator.go_to(frame)
    qtbot.waitUntil(lambda: window.services.scorer.score is not None, timeout=20_000)
    score = window.services.scorer.score
    return score.jac


def test_a_frame_is_shown_and_judged_with_its_own_dimensions(make_window, annotated, qtbot):
    window = make_window(annotated)
    names = [frame.name for frame in window.services.state.workspace.frames]
    plain = judged_at(window, annotated, 1, qtbot)
    (annotated / "stadiums.csv").write_text(
        f"frame,stadium,length,width\n{names[1]},small,99,62\n{names[2]},big,,\n"
    )
    window = make_window(annotated)
    window.services.navigator.go_to(0)
    assert length(window) == 105
    assert judged_at(window, annotated, 1, qtbot) < plain
    assert length(window) == 99
    window.services.navigator.go_to(2)
    assert length(window) == 105
    assert "dimensions of 2 stadiums" in window.services.state.field.described
    assert window.services.state.sized_field == load_field("soccer")
    window.panels.show("scores")
    window.services.navigator.go_to(1)
    # One object for every frame of a stadium, or what is worked out of it would not be kept.
    assert window.services.state.sized_field is window.services.scorer.frame_setup.field
    qtbot.waitUntil(lambda: "99 x 62 m" in window.scores.terms.text(), timeout=20_000)


def test_dimensions_that_are_entered_leave_the_stadiums_as_they_are(make_window, annotated, qtbot):
    path = annotated / "stadiums.csv"
    path.write_text("frame,stadium,length\n00002,small,99\n")
    window = make_window(annotated)
    services = window.services
    window.actions_["field_dimensions"].trigger()
    dialog = window.field_dimensions.dialog
    assert "(stadiums.csv): 1 frame of 1 stadium" in dialog.note.text()
    dialog.reject()
    services.field_choice.resize({"width": 66.0})
    qtbot.waitUntil(lambda: "66" in services.state.field.described, timeout=20_000)
    services.navigator.go_to(1)
    found = {d.name: d.value for d in services.scorer.frame_setup.field.dimensions}
    assert (found["length"], found["width"]) == (99, 66)


def test_a_damaged_file_is_told_when_the_dataset_opens(make_window, annotated):
    (annotated / "stadiums.csv").write_text("frame,stadium,length\n00002,small,9\n")
    window = make_window(annotated)
    assert "stadiums.csv: line 2" in window.message_bar.label.text()
    window.services.navigator.go_to(1)
    assert length(window) == 105
