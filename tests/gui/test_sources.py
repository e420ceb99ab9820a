"""Several camera sources of one dataset: how they are kept, judged, drawn and remembered."""

import shutil
from functools import partial
from typing import TypeVar

import pytest
from PySide6.QtCore import QObject, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QTabBar, QToolButton, QWidget

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.gui.app import CameraChoice
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.camera_sources import SourceRow
from procc_annotator.gui.panels.cameras import CamerasPanel
from procc_annotator.gui.panels.widgets import ElidedLabel
from procc_annotator.gui.settings import SOURCES, Settings
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.window.top_bar import CameraBar
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from tests.gui.conftest import draw, heard, settle

Found = TypeVar("Found", bound=QObject)
NONE, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier


def jac_here(services: Services, name: str) -> float:
    """The JaC that the metric's own functions give the frame on screen under a set of cameras."""
    path = next(
        s.path for s in [look.cameras for look in services.state.looks] if s.path.name == name
    )
    found = CameraSet.open(path).camera(services.state.frame.name, services.state.setup.size)
    return score(
        measure(services.state.annotation, found.camera, services.state.setup), services.state.tau
    ).jac


def source(services: Services, name: str) -> CameraSource:
    return next(s for s in services.state.sources if s.name == name)


@pytest.fixture
def services(scored) -> Services:
    return scored


class TestAudits:
    def test_every_source_is_audited_whichever_is_active(self, services):
        frame = services.state.frame.name
        for name in ("true", "bad"):
            audits = source(services, name).audits
            assert audits[frame].jac_at(services.state.tau) == pytest.approx(
                jac_here(services, name), abs=1e-6
            )
        assert len(source(services, "true").audits) > len(source(services, "bad").audits) > 0

    def test_the_mean_is_that_of_the_frames_at_any_threshold(self, services):
        bad = source(services, "bad")
        for tau in (2.0, 5.0, 17.3):
            values = [audit.jac_at(tau) for audit in bad.audits.values()]
            assert bad.mean_jac(tau) == pytest.approx(sum(values) / len(values), abs=1e-9)
        assert bad.mean_jac(2.0) < bad.mean_jac(20.0)

    def test_switching_computes_nothing_of_the_set_anew(self, services, qtbot):
        before = dict(source(services, "bad").audits)
        services.camera_sources.set_active_camera(1)
        assert not services.scoring.running
        assert source(services, "bad").audits == before
        assert dict(services.scoring.frame_scores) == {
            name: audit.jac_at(services.state.tau) for name, audit in before.items()
        }

    def test_an_edit_is_audited_under_every_source(self, services, qtbot):
        frame = services.state.frame.name
        before = {s.name: s.audits[frame] for s in services.state.sources if frame in s.audits}
        told: list[object] = []
        services.store.events.sourceAuditsChanged.connect(told.append)
        draw(services, "Circle central", (0.08, 0.83), (0.14, 0.86), (0.23, 0.89))
        bad = source(services, "bad")
        qtbot.waitUntil(lambda: services.state.active.audits[frame] is not before["true"])
        qtbot.waitUntil(lambda: bad.audits[frame] is not before["bad"])
        for name in ("true", "bad"):
            assert source(services, name).audits[frame].jac_at(services.state.tau) == pytest.approx(
                jac_here(services, name), abs=1e-6
            )
        assert {services.state.active, bad} <= set(told)

    def test_terms_apply_to_every_source(self, services, qtbot):
        services.evaluation.set_protocol("procc")
        settle(services, qtbot)
        for name in ("true", "bad"):
            assert source(services, name).audits[services.state.frame.name].jac_at(
                services.state.tau
            ) == pytest.approx(jac_here(services, name), abs=1e-6)

    def test_a_damaged_camera_is_known_by_its_frame(self, open_services, annotated, qtbot):
        (annotated / "cameras" / "bad" / "camera_00003.json").write_text("{")
        services = open_services(annotated)
        services.live_fit.set_wanted(False)
        services.camera_sources.load_cameras(annotated / "cameras" / "bad")
        settle(services, qtbot)
        (bad,) = services.state.sources
        assert list(bad.problems) == ["00003"]
        assert "camera_00003.json" in bad.problems["00003"]
        assert "00002" in bad.audits


def child(parent: QWidget, kind: type[Found], name: str) -> Found:
    found = parent.findChild(kind, name)
    assert found is not None, name
    return found


def mean_jac(services: Services, name: str, tau: float) -> float:
    """The mean of what the metric's own functions give every frame that has both."""
    cameras = CameraSet.open(
        next(s.path for s in [look.cameras for look in services.state.looks] if s.path.name == name)
    )
    values = []
    for index, frame in enumerate(services.state.workspace.frames):
        annotation = services.state.workspace.read(index)
        found = cameras.camera(frame.name, services.state.setup.size)
        if annotation.annotated and found is not None:
            values.append(score(measure(annotation, found.camera, services.state.setup), tau).jac)
    return sum(values) / len(values)


class TestRows:
    @pytest.fixture
    def panel(self, services, show, qtbot) -> CamerasPanel:
        panel = show(CamerasPanel(services))
        qtbot.waitUntil(lambda: "JaC" in child(panel, QLabel, "cameras_jac_2").text())
        return panel

    def test_a_row_says_how_its_source_does(self, services, qtbot, panel):
        for index, name in enumerate(("true", "bad", "pinhole")):
            expected = f"JaC {mean_jac(services, name, 5.0):.3f}"
            label = child(panel, QLabel, f"cameras_jac_{index}")
            qtbot.waitUntil(lambda label=label, text=expected: label.text() == text)
        assert child(panel, QLabel, "cameras_matched_1").text() == "5 of 6 (83 %)"
        assert child(panel, ElidedLabel, "cameras_model_1").text() == "pinhole P"
        services.evaluation.set_tau(12.0)
        expected = f"JaC {mean_jac(services, 'bad', 12.0):.3f}"
        assert expected != f"JaC {mean_jac(services, 'bad', 5.0):.3f}"
        qtbot.waitUntil(lambda: child(panel, QLabel, "cameras_jac_1").text() == expected)
        assert not services.scoring.running  # nothing was computed for it

    def test_rows_keep_their_height_where_the_panel_is_low(self, services, annotated, qtbot, panel):
        assert services.camera_sources.load_cameras(annotated / "cameras" / "homography")
        services.camera_sources.set_active_camera(0)
        settle(services, qtbot)
        qtbot.waitUntil(lambda: len(panel.list.rows) == 4)
        panel.setMaximumHeight(220)
        qtbot.waitUntil(lambda: panel.height() <= 220)
        qtbot.waitUntil(
            lambda: all(row.height() >= row.minimumSizeHint().height() for row in panel.list.rows)
        )

    def test_a_click_anywhere_on_a_row_makes_it_the_one_judged(self, services, panel, show):
        row = child(panel, SourceRow, "cameras_row_1")
        at = row.jac.mapTo(row, row.jac.rect().center())
        QTest.mouseClick(row, Qt.MouseButton.LeftButton, pos=at)
        assert services.state.active.name == "bad"
        assert show(CameraBar(services)).cameras.currentText() == "bad"

    def test_a_double_click_lets_the_name_be_typed(self, services, qtbot, panel):
        row = panel.list.rows[1]  # not one that is about to be deleted
        QTest.mouseDClick(row.radio, Qt.MouseButton.LeftButton)
        assert row.edit.isVisible()
        QTest.keyClicks(row.edit, "TV  X")
        QTest.keyClick(row.edit, Qt.Key.Key_Return)
        assert [s.name for s in services.state.sources] == ["true", "TV X", "pinhole"]
        qtbot.waitUntil(lambda: row.radio.text() == "TV X")
        assert not row.edit.isVisible()
        QTest.keyClick(row.radio, Qt.Key.Key_F2)
        QTest.keyClicks(row.edit, "something else")
        QTest.keyClick(row.edit, Qt.Key.Key_Escape)
        assert row.radio.text() == "TV X"

    def test_no_two_sources_have_the_same_name(self, services):
        services.camera_sources.rename_source(services.state.sources[1], "true")
        assert services.state.sources[1].name == "true (2)"

    def test_another_colour_can_be_chosen(self, services, panel):
        row = child(panel, SourceRow, "cameras_row_1")
        navy = row.colour.menu().actions()[4]
        assert navy.text() == "Navy"
        navy.trigger()
        assert services.state.sources[1].colour == SOURCE_COLOURS[4]

    def test_a_source_without_camera_here_says_so(self, services, qtbot, panel):
        services.navigator.go_to(3)  # bad has none of 00004
        note = child(panel, QLabel, "cameras_problem_1")
        qtbot.waitUntil(lambda: "no camera for this frame" in note.text())
        assert not child(panel, QLabel, "cameras_problem_2").isVisible()

    def test_a_source_whose_file_is_damaged_says_where(self, services, annotated, qtbot, panel):
        (annotated / "cameras" / "homography" / "00006.homographyMatrix").write_text("1 2")
        services.camera_sources.load_cameras(annotated / "cameras" / "homography")
        services.camera_sources.set_active_camera(0)
        services.navigator.go_to(5)
        qtbot.waitUntil(lambda: len(panel.list.rows) == 4)
        note = child(panel, QLabel, "cameras_problem_3")
        qtbot.waitUntil(lambda: "00006.homographyMatrix" in note.text())

    def test_a_removed_source_takes_its_row_along(self, services, qtbot, panel):
        child(panel, QToolButton, "cameras_remove_1").click()
        assert [s.name for s in services.state.sources] == ["true", "pinhole"]
        qtbot.waitUntil(lambda: len(panel.list.rows) == 2)
        assert services.state.active.name == "true"


class TestKeys:
    def test_c_goes_on_and_shift_c_goes_back(self, audited, hand_on):
        hand, services = hand_on(audited), audited.services
        names = []
        for modifiers in (NONE, NONE, NONE, SHIFT):
            hand.key(Qt.Key.Key_C, modifiers)
            names.append(services.state.active.name)
        assert names == ["bad", "pinhole", "true", "pinhole"]


class TestCompared:
    def test_it_is_the_one_active_before_unless_one_is_chosen(self, services):
        true, bad, pinhole = services.state.sources
        services.camera_sources.set_active_camera(2)
        assert services.state.compared is true
        services.camera_sources.set_active_camera(1)
        assert services.state.compared is pinhole
        services.camera_sources.compare_with(true)
        services.camera_sources.set_active_camera(2)
        assert services.state.compared is true
        services.camera_sources.swap_sources()
        assert (services.state.active, services.state.compared) == (true, pinhole)
        services.camera_sources.remove_camera_set(2)
        assert services.state.compared is bad


class TestMemory:
    def test_sources_come_back_with_their_dataset(self, audited, annotated, make_window, qtbot):
        services = audited.services
        services.camera_sources.rename_source(services.state.sources[1], "worse")
        services.camera_sources.set_source_colour(services.state.sources[2], "#22e6ff")
        services.camera_sources.set_source_visible(services.state.sources[0], False)
        services.camera_sources.set_active_camera(1)
        audited.close()
        again = make_window(annotated)
        qtbot.waitUntil(lambda: len(again.services.state.sources) == 3)
        found = [(s.name, s.colour, s.visible) for s in again.services.state.sources]
        assert found == [(s.name, s.colour, s.visible) for s in services.state.sources]
        assert again.services.state.active.name == "worse"
        settle(again.services, qtbot)
        assert again.services.state.active.audits

    def test_what_is_not_there_any_more_is_told(self, audited, annotated, make_window, qtbot):
        audited.close()
        shutil.rmtree(annotated / "cameras" / "bad")
        again = make_window(annotated)
        qtbot.waitUntil(lambda: len(again.services.state.sources) == 2)
        assert str(annotated / "cameras" / "bad") in again.message_bar.label.text()

    def test_another_dataset_brings_its_own(self, audited, annotated, dataset, qtbot):
        services = audited.services
        audited.opening.open_path(dataset)
        assert services.state.sources == ()
        assert services.state.active is None
        audited.opening.open_path(annotated)
        qtbot.waitUntil(
            lambda: [s.name for s in services.state.sources] == ["true", "bad", "pinhole"]
        )
        assert services.state.active.name == "true"

    def test_sources_named_at_the_start_are_judged_first(
        self, audited, annotated, make_window, qtbot
    ):
        audited.services.camera_sources.rename_source(
            audited.services.state.sources[0], "reference"
        )
        audited.close()
        choices = [
            CameraChoice(annotated / "cameras" / "homography", name="flat"),
            CameraChoice(annotated / "cameras" / "true"),
        ]
        again = make_window(annotated, cameras=choices)
        assert again.services.state.active.name == "flat"
        qtbot.waitUntil(lambda: len(again.services.state.sources) == 4)
        names = [s.name for s in again.services.state.sources]
        assert names == ["flat", "reference", "bad", "pinhole"]
        assert again.services.state.active.name == "flat"

    def test_settings_that_make_no_sense_are_left_alone(self, make_window, annotated, qtbot):
        settings = Settings()
        settings.set(SOURCES, {"x": 1, str(annotated.resolve()): [{"path": 3}, 7]})
        settings.sync()
        window = make_window(annotated)
        assert window.services.state.sources == ()
        assert window.services.camera_sources.load_cameras(annotated / "cameras" / "bad")

    def test_loading_the_same_again_reads_the_files_anew(self, services, annotated, qtbot):
        bad = source(services, "bad")
        before = bad.mean_jac(5.0)
        for path in (annotated / "cameras" / "bad").glob("*.json"):
            shutil.copy(annotated / "cameras" / "true" / path.name, path)
        services.camera_sources.load_cameras(annotated / "cameras" / "bad")
        settle(services, qtbot)
        assert len(services.state.sources) == 3
        assert services.state.active is bad
        assert bad.mean_jac(5.0) > before


class TestUnreadable:
    """Two cameras of "bad" are damaged: they count as missing, and every place says which."""

    @pytest.fixture
    def damaged(self, make_window, annotated, qtbot) -> MainWindow:
        folder = annotated / "cameras" / "bad"
        for name in ("00002", "00003"):
            next(folder.glob(f"*{name}*")).write_text("{")
        window = make_window(annotated)
        for name in ("true", "bad"):
            assert window.services.camera_sources.load_cameras(folder.parent / name)
        window.services.navigator.go_to(1)
        settle(window.services, qtbot)
        return window

    def test_the_row_counts_and_names_them(self, damaged, qtbot):
        damaged.panels.show("cameras")
        # Looked up anew each time: rows of the dataset before go a turn later than they are left.
        matched = partial(child, damaged, QLabel, "cameras_matched_1")
        qtbot.waitUntil(lambda: matched().text() == "3 of 6, 2 unreadable")
        assert "50 %" in matched().toolTip()
        assert "2 cameras cannot be read" in child(damaged, QLabel, "cameras_jac_1").toolTip()
        assert "00002, 00003" in matched().toolTip()
        assert child(damaged, QLabel, "cameras_matched_0").text() == "6 of 6 (100 %)"

    def test_bar_and_list_say_it(self, damaged):
        assert "camera unreadable" in damaged.top_bar.camera_bar.jac.text()
        assert "00002" in damaged.top_bar.camera_bar.jac.toolTip()
        model = damaged.frames.model
        assert "00002" in model.info(1).camera_problem
        assert model.info(0).camera_problem == ""
        damaged.services.camera_sources.set_active_camera(0)
        assert "JaC" in damaged.top_bar.camera_bar.jac.text()
        assert model.info(1).camera_problem == ""

    def test_the_names_over_the_picture_say_it(self, damaged):
        QTest.keyClick(damaged.canvas, Qt.Key.Key_B, Qt.KeyboardModifier.ControlModifier)
        split = damaged.canvas.comparison.split
        assert split.left.text == "bad  ·  camera unreadable"
        assert "JaC" in split.right.text
        damaged.services.navigator.go_to(3)  # the file is not there at all
        assert split.left.text == "bad  ·  no camera here"

    def test_the_filter_finds_them(self, damaged, qtbot):
        model = damaged.frames.model

        def shown() -> list[str]:
            return [model.info(row).name for row in range(model.rowCount())]

        damaged.frames.filter.setText("camera:unreadable")
        qtbot.waitUntil(lambda: shown() == ["00002", "00003"])
        damaged.frames.filter.setText("camera:none")
        qtbot.waitUntil(lambda: shown() == ["00004"])
        damaged.frames.filter.setText("-camera:none,unreadable")
        qtbot.waitUntil(lambda: shown() == ["00001", "00005", "00006"])
        damaged.services.camera_sources.set_active_camera(0)
        qtbot.waitUntil(lambda: len(shown()) == 6)


def test_cameras_of_no_frame_are_told(services, annotated):
    """A file named like no frame would else be judged as if nothing were wrong with it."""
    told = heard(services)
    stray = annotated / "stray.json"
    stray.write_bytes((annotated / "cameras" / "true" / "camera_00001.json").read_bytes())
    services.camera_sources.load_cameras(stray)
    said = told[-1]
    assert "no camera has the name of a frame" in said
    assert "'stray'" in said
    assert "'00001'" in said
    stray.write_text("{}")
    services.camera_sources.load_cameras(stray)
    assert "stray.json: holds no camera of a known format" in told[-1]


def test_tabs_of_panels_show_whole_words_from_the_start(make_window, annotated):
    window = make_window(annotated)
    bars = window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)
    assert bars
    assert all(bar.elideMode() == Qt.TextElideMode.ElideNone for bar in bars)
