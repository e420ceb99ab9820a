"""What a window says keeps up with what it says it of."""

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.locks import FrameLocks, locks_folder
from procc_annotator.dataset.records import Status
from procc_annotator.field.load import load_field
from procc_annotator.gui.commands.versions import apply_version
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import AUTHOR
from tests.gui.conftest import Hand, heard, settle, until_kept

HandOn = Callable[[MainWindow], "Hand"]
MIDDLE = "Middle line"
ENDS = (100, 100), (200, 200)


@pytest.fixture
def second_annotator(annotated, tmp_path) -> Path:
    """Somebody who clicked the very same."""
    other = tmp_path / "other"
    other.mkdir()
    for path in annotated.glob("*.json"):
        shutil.copy(path, other)
    return other


def test_of_two_sources_of_one_colour_the_legend_names_the_one_that_is_drawn(audited):
    services = audited.services
    judged, other = services.state.sources[:2]
    assert services.state.active is judged
    for source in services.state.sources[2:]:
        services.camera_sources.set_source_visible(source, False)
    services.camera_sources.set_source_colour(other, judged.colour)
    services.camera_sources.set_source_visible(other, True)
    named = [name for name, _ in audited.canvas.comparison.names_of_others()]
    assert named == [other.name]


def test_who_is_editing_is_another_one_than_before(window, dataset):
    services, folder = window.services, locks_folder(dataset)
    ann, bob = (
        FrameLocks(folder, "Ann"),
        FrameLocks(folder, "Bob"),
    )
    assert ann.acquire("frame_0") is None
    services.frame_lock.look()
    assert "Ann" in services.state.why_not_editable
    ann.release("frame_0")
    assert bob.acquire("frame_0") is None
    services.frame_lock.look()
    assert "Bob" in services.state.why_not_editable
    bob.release("frame_0")


def test_others_see_the_name_that_was_entered_last(window, hand, dataset):
    window.options.change(AUTHOR, "Grace")
    hand.draw(MIDDLE, *ENDS)
    (lock,) = locks_folder(dataset).glob("*.lock")
    assert json.loads(lock.read_text())["author"] == "Grace"
    window.options.change(AUTHOR, "Ada")
    window.services.frame_lock.beat()
    assert json.loads(lock.read_text())["author"] == "Ada"


def test_frames_that_are_saved_by_now_leave_the_list_of_unsaved_ones(
    window, hand, qtbot, monkeypatch
):
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    hand.draw(MIDDLE, *ENDS)
    settle(window.services, qtbot)
    with monkeypatch.context() as broken:
        broken.setattr("procc_annotator.formats.atomic.os.open", full)
        window.services.editing.undo()
        window.frames.filter.setText("is:unsaved")
        qtbot.waitUntil(lambda: window.frames.model.shown == 1)
    window.services.editing.save_now()
    qtbot.waitUntil(lambda: window.frames.model.shown == 0)


class TestBlind:
    def test_distances_to_a_second_annotator_are_hidden(self, audited, second_annotator, qtbot):
        panel, services = audited.agreement, audited.services
        services.second_annotator.open(second_annotator)
        qtbot.waitUntil(lambda: panel.rows.rowCount() > 0)
        services.blind_lock.set_blind(True)
        qtbot.waitUntil(lambda: panel.rows.rowCount() == 0)
        assert panel.frame.text().startswith("Hidden")
        services.editing.commit_frame()
        qtbot.waitUntil(lambda: panel.rows.rowCount() > 0)

    def test_a_camera_that_cannot_be_read_is_told_of_once_the_frame_is_committed(
        self, audited, qtbot
    ):
        services, model = audited.services, audited.frames.model
        name = services.state.frame.name
        services.state.active.problems[name] = "cannot be read"
        assert model._camera_problem(name)
        services.blind_lock.set_blind(True)
        assert not model._camera_problem(name)
        audited.frames.filter.setText("camera:unreadable")
        qtbot.waitUntil(lambda: model.shown == 0)


def test_the_sheet_of_keys_shows_the_elements_of_the_field_there_is(window, qtbot):
    window.commands.show_keys()
    sheet = window.commands._sheet

    def elements() -> list[str]:
        return [row.text for row in sheet.table.shown()]

    assert "Halfway line" in " ".join(elements())
    window.services.evaluation.set_field(load_field("basketball_fiba"))
    assert "Halfway line" not in " ".join(elements())
    sheet.close()


class TestDamage:
    @pytest.fixture
    def damaged(self, window, hand, dataset) -> MainWindow:
        hand.draw(MIDDLE, *ENDS)
        until_kept()
        (dataset / "frame_0.json").write_text('{"Middle line": [{')
        window.services.editing.look_at_frame()
        assert window.services.state.damage
        return window

    def test_nobody_is_done_with_a_frame_that_cannot_be_read(self, damaged):
        damaged.services.editing.commit_frame()
        assert damaged.services.review.status("frame_0") is not Status.DONE

    def test_an_earlier_version_takes_the_place_of_a_file_that_cannot_be_read(
        self, damaged, dataset, qtbot
    ):
        services = damaged.services
        database = services.review.database
        version = database.versions("frame_0")[-1].id
        apply_version(services, version)
        assert services.state.annotation.annotated == (MIDDLE,)
        assert not services.state.damage
        assert list(json.loads((dataset / "frame_0.json").read_text())) == [MIDDLE]
        kept = [database.version_data(v.id) for v in database.versions("frame_0")]
        assert b'{"Middle line": [{' in kept
        settle(damaged.services, qtbot)

    def test_keys_that_need_the_picture_say_why_they_do_nothing(self, make_window, annotated):
        first = sorted(annotated.glob("*.jpg"))[0]
        first.write_bytes(b"no picture")
        window = make_window(annotated)
        said = heard(window.services)
        for name in ("regularise", "regularise_all", "close_gaps"):
            said.clear()
            window.services.selection.select_class(window.services.state.annotation.annotated[0])
            window.actions_[name].trigger()
            assert any(first.name in text for text in said), name


def test_a_dataset_whose_pictures_lie_in_a_folder_of_it_is_opened_when_dropped(
    window, striped, tmp_path
):
    inner = tmp_path / "match" / "images"
    inner.mkdir(parents=True)
    (inner / "a.png").write_bytes(striped[0])
    window.opening.drop([tmp_path / "match"])
    assert window.services.state.workspace.root == tmp_path / "match"
    assert not window.services.state.sources


class TestWhatWasLeft:
    def test_a_comment_that_is_half_typed_stays_with_its_frame(self, window, annotated):
        box, services = window.review.text, window.services
        box.setText("the post is")
        services.navigator.go_to(1)
        assert box.text() == ""
        services.navigator.go_to(0)
        assert box.text() == "the post is"
        services.opening.open_path(annotated)
        assert box.text() == ""

    def test_undo_right_after_a_status_gives_the_one_before_again(self, window, hand):
        hand.draw("Middle line", (300, 50), (300, 300))
        name, review = window.services.state.frame_name, window.services.review
        window.actions_["reject"].trigger()
        assert review.status(name) is Status.REJECTED
        window.actions_["undo"].trigger()
        assert review.status(name) is Status.IN_PROGRESS
        assert window.services.state.annotation.annotated == ("Middle line",)
        window.actions_["undo"].trigger()
        assert window.services.state.annotation.annotated == ()

    def test_approved_in_the_panel_stays_when_a_line_was_under_way(self, window, hand):
        window.services.selection.select_class(MIDDLE)
        hand.click(100, 100)
        window.actions_["approve"].trigger()
        window.services.navigator.go_to(1)
        assert window.services.review.status("frame_0") is Status.APPROVED

    def test_a_frame_left_before_its_fit_came_keeps_no_fit_of_other_clicks(self, begun, qtbot):
        services = begun.services
        name, fits = services.state.frame.name, services.fit_source
        qtbot.waitUntil(lambda: name in fits.cameras.fits)
        first = services.state.annotation.annotated[0]
        services.editing.edit("taken out", lambda seen: seen.without(first))
        services.navigator.next_frame()
        assert name not in fits.cameras.fits
        settle(begun.services, qtbot)

    def test_the_noise_of_two_annotators_follows_the_clicks(self, audited, second_annotator, qtbot):
        panel, services = audited.agreement, audited.services
        services.second_annotator.open(second_annotator)
        qtbot.waitUntil(lambda: "median 0.00 px" in panel.noise.text())
        line = services.state.annotation.polylines[0]
        moved = tuple(point._replace(v=point.v + 0.02) for point in line.points)
        others = tuple(p for p in services.state.annotation.polylines if p is not line)
        services.editing.commit_edit(
            "moved", FrameAnnotation((replace(line, points=moved), *others))
        )
        before = services.state.noise_floor
        qtbot.waitUntil(lambda: services.state.noise_floor != before)
        settle(audited.services, qtbot)


def test_what_is_regularised_first_is_done_when_the_next_is_asked_for(begun, qtbot):
    services = begun.services
    for name in services.state.annotation.annotated[:2]:
        services.selection.select_class(name)
        begun.assistant.regularise_named(name)
    qtbot.waitUntil(lambda: not begun.assistant._work.running)
    steps = []
    while (step := services.editing.steps[0]) is not None:
        steps.append(step)
        services.editing.undo()
    assert sum("regularise" in step for step in steps) == 2


class TestPaintedWidth:
    def test_it_is_drawn_in_the_next_frame_too(self, audited, qtbot):
        services = audited.services
        services.line_widths.set_enabled(True)
        qtbot.waitUntil(lambda: services.line_widths.value is not None)
        services.navigator.next_frame()
        qtbot.waitUntil(lambda: services.line_widths.value is not None)
        services.line_widths.set_enabled(False)
