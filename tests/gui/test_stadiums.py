"""In the window each frame of a set of several stadiums has the dimensions of its own."""

from pathlib import Path

from pytestqt.qtbot import QtBot

from procc_annotator.field.load import load_field
from procc_annotator.gui.commands.field_dimensions import FieldDimensionsTask
from procc_annotator.gui.panels.scores import ScoresPanel
from procc_annotator.gui.state.services import Services
from tests.gui.conftest import heard


def length(services: Services) -> float:
    found = services.scorer.frame_setup.field.dimension("length")
    return found.value


def judged_at(services: Services, folder: Path, frame: int, qtbot: QtBot) -> float:
    assert services.camera_sources.load_cameras(folder / "cameras" / "true")
    services.navigator.go_to(frame)
    qtbot.waitUntil(lambda: services.scorer.score is not None)
    score = services.scorer.score
    return score.jac


def test_a_frame_is_shown_and_judged_with_its_own_dimensions(show, open_services, annotated, qtbot):
    services = open_services(annotated)
    names = [frame.name for frame in services.state.workspace.frames]
    plain = judged_at(services, annotated, 1, qtbot)
    (annotated / "stadiums.csv").write_text(
        f"frame,stadium,length,width\n{names[1]},small,99,62\n{names[2]},big,,\n"
    )
    services = open_services(annotated)
    services.navigator.go_to(0)
    assert length(services) == 105
    assert judged_at(services, annotated, 1, qtbot) < plain
    assert length(services) == 99
    services.navigator.go_to(2)
    assert length(services) == 105
    assert "dimensions of 2 stadiums" in services.state.field.described
    assert services.state.sized_field == load_field("soccer")
    scores = show(ScoresPanel(services))
    services.navigator.go_to(1)
    # One object for every frame of a stadium, or what is worked out of it would not be kept.
    assert services.state.sized_field is services.scorer.frame_setup.field
    qtbot.waitUntil(lambda: "99 x 62 m" in scores.terms.text())


def test_dimensions_that_are_entered_leave_the_stadiums_as_they_are(
    widget, open_services, annotated, qtbot
):
    path = annotated / "stadiums.csv"
    path.write_text("frame,stadium,length\n00002,small,99\n")
    services = open_services(annotated)
    task = FieldDimensionsTask(services, widget)
    task.ask()
    dialog = task.dialog
    assert "(stadiums.csv): 1 frame of 1 stadium" in dialog.note.text()
    dialog.reject()
    services.field_choice.resize({"width": 66.0})
    qtbot.waitUntil(lambda: "66" in services.state.field.described)
    services.navigator.go_to(1)
    found = {d.name: d.value for d in services.scorer.frame_setup.field.dimensions}
    assert (found["length"], found["width"]) == (99, 66)


def test_a_damaged_file_is_told_when_the_dataset_opens(open_services, annotated):
    (annotated / "stadiums.csv").write_text("frame,stadium,length\n00002,small,9\n")
    services = open_services()
    told = heard(services)
    services.opening.open_path(annotated)
    assert "stadiums.csv: line 2" in told[-1]
    services.navigator.go_to(1)
    assert length(services) == 105
