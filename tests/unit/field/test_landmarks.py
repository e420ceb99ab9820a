"""A dataset's landmarks as elements of its field."""

import pytest

from procc_annotator.errors import FieldError
from procc_annotator.field.geometry import Spot
from procc_annotator.field.landmarks import field_at, with_landmarks, without_landmarks
from procc_annotator.field.load import load_field, with_dimensions
from procc_annotator.field.model import Landmark

SEAT = Landmark("Seat 12", "Seat, row 12", (10.0, -45.0, -6.5), colour="#123456", shortcut="F7")
BALL = (
    Landmark("Ball", moving=True, shortcut="Ctrl+B"),
    Landmark("Ball", position=(1.0, 2.0, -3.0), instant="17"),
    Landmark("Ball", position=(4.0, 5.0, -6.0), instant="18"),
)


def test_a_landmark_with_a_position_is_an_optional_spot_of_the_field():
    field = with_landmarks(load_field(), [SEAT])
    element = field.element("Seat 12")
    assert element.optional
    assert element.is_spot
    assert element.geometry == Spot((10.0, -45.0, -6.5))
    assert (element.title, element.colour, element.shortcut) == ("Seat, row 12", "#123456", "F7")
    assert field.canonical_name("Seat 12 ") == "Seat 12"
    assert field.symmetries[0].name_of("Seat 12") == "Seat 12"


def test_a_landmark_without_a_position_can_be_clicked_but_has_no_geometry():
    field = with_landmarks(load_field(), [Landmark("Mast")])
    assert field.knows("Mast")
    assert field.element("Mast") is None


def test_a_moving_object_is_where_it_was_at_the_instant():
    field = with_landmarks(load_field(), BALL)
    assert field.element("Ball") is None
    assert field.knows("Ball")
    for instant, x in (("17", 1.0), ("18", 4.0)):
        ball = field_at(field, instant).element("Ball")
        assert ball.geometry.position[0] == x
        assert ball.shortcut == "Ctrl+B"
    assert field_at(field_at(field, "18"), "19") == field_at(field, "19")
    assert field_at(field, "19").element("Ball") is None


def test_nothing_is_made_anew_where_nothing_moves():
    field = with_landmarks(load_field(), [SEAT])
    assert field_at(field, "17") is field


def test_other_dimensions_leave_the_landmarks_where_they_are():
    field = with_landmarks(load_field(), [SEAT, *BALL], "17")
    sized = with_dimensions(field, {"length": 100.0})
    assert sized.element("Seat 12") == field.element("Seat 12")
    assert sized.element("Ball") == field.element("Ball")
    assert sized.landmarks == field.landmarks


def test_landmarks_replace_each_other_and_go_without_a_trace():
    plain = load_field()
    field = with_landmarks(with_landmarks(plain, [SEAT]), BALL)
    assert field.element("Seat 12") is None
    assert field.knows("Ball")
    assert without_landmarks(field) == plain
    assert with_landmarks(field, []) == plain


def test_colours_of_landmarks_that_name_none_differ():
    marks = [Landmark(f"L{i}", position=(float(i), 0.0, 0.0)) for i in range(5)]
    field = with_landmarks(load_field(), marks)
    colours = [e.colour for e in field.elements if e.group == "Landmarks"]
    assert len(set(colours)) == 5


def test_the_field_keeps_its_keys():
    taken = next(e.shortcut for e in load_field().elements if e.shortcut)
    marks = [Landmark("A", position=(0.0, 0.0, 0.0), shortcut=taken)]
    element = with_landmarks(load_field(), marks).element("A")
    assert element.shortcut == ""


@pytest.mark.parametrize("name", ["Middle line", "Line unknown", "Goal left crossbar"])
def test_a_landmark_cannot_have_the_name_of_a_class(name):
    with pytest.raises(FieldError, match="has the name of a class of the field"):
        with_landmarks(load_field(), [Landmark(name)])


def test_a_colour_does_not_depend_on_the_other_landmarks():
    marks = [Landmark(name, position=(0.0, 0.0, 0.0)) for name in ("Clock", "Mast", "Seat")]
    all_of_them = with_landmarks(load_field(), marks)
    two = with_landmarks(load_field(), marks[:0:-1])
    for name in ("Mast", "Seat"):
        colours = {field.element(name).colour for field in (all_of_them, two)}
        assert len(colours) == 1
