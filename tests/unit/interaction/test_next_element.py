"""The element offered next: what the frame before had, the same rectangle, then neighbours."""

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import touching_elements
from procc_annotator.interaction.class_choice import loose_rank, match_rank, misspelt, next_element

FIELD = load_field()


def annotated(*names: str) -> FrameAnnotation:
    return FrameAnnotation(tuple(Polyline(n, (Point(0.5, 0.5),)) for n in names))


def test_the_same_rectangle_comes_first_by_what_meets():
    first = "Big rect. left main"
    order = [first]
    while len(order) < 4:
        following = next_element(FIELD, annotated(*order), order[-1])
        assert following is not None
        order.append(following)
    assert set(order) == {e.name for e in FIELD.elements if e.group == "Left penalty area"}
    assert order[1] in touching_elements(FIELD, first)


def test_what_the_frame_before_had_comes_before_the_rest():
    seen = ("Side line top", "Middle line", "Circle left")
    assert next_element(FIELD, annotated("Middle line"), "Middle line", seen) == "Side line top"
    drawn = annotated("Circle left", "Middle line")
    assert next_element(FIELD, drawn, "Circle left", seen) == "Side line top"


def test_another_view_than_the_frame_before_goes_by_the_field_alone():
    seen = ("Side line top", "Middle line")
    following = next_element(FIELD, annotated("Circle right"), "Circle right", seen)
    assert following == "Big rect. right main"


def test_nothing_is_offered_when_all_is_done_or_nothing_is_known():
    everything = annotated(*(e.name for e in FIELD.elements))
    assert next_element(FIELD, everything, "Middle line") is None
    assert next_element(FIELD, annotated(), None) is None
    assert next_element(FIELD, annotated(), None, ("Circle left",)) == "Circle left"
    assert next_element(FIELD, annotated(), "Line unknown") is None


def test_what_a_set_need_not_have_comes_where_the_frame_before_had_it():
    needed = [e.name for e in FIELD.elements if not e.optional]
    corner = "Corner arc left top"
    assert next_element(FIELD, annotated(corner), corner) in needed
    assert next_element(FIELD, annotated(*needed[1:]), "Side line left") == needed[0]
    assert next_element(FIELD, annotated(*needed), "Side line left") is None
    seen = ("Penalty mark left", "Side line top")
    following = next_element(FIELD, annotated("Side line top"), "Side line top", seen)
    assert following == "Penalty mark left"


def test_elements_meet_where_the_laws_of_the_game_say():
    assert set(touching_elements(FIELD, "Circle left")) == {"Big rect. left main"}
    assert set(touching_elements(FIELD, "Middle line")) == {
        "Centre mark", "Circle central", "Side line bottom", "Side line top"
    }  # fmt: skip
    assert touching_elements(FIELD, "Line unknown") == ()
    for element in FIELD.elements:
        for other in touching_elements(FIELD, element.name):
            assert element.name in touching_elements(FIELD, other)


def test_what_a_camera_suggests_comes_first_and_what_it_has_not_in_sight_never():
    drawn = annotated("Big rect. left main")
    plain = next_element(FIELD, drawn, "Big rect. left main")
    assert plain is not None
    other = next_element(FIELD, drawn, "Big rect. left main", out_of_sight={plain})
    assert other not in (plain, None)
    gains = {"Big rect. left main": 3.0, "Middle line": 2.0, "Side line top": 1.0}
    assert next_element(FIELD, drawn, "Big rect. left main", gains=gains) == "Middle line"
    assert (
        next_element(
            FIELD,
            drawn,
            "Big rect. left main",
            gains=gains,
            out_of_sight={"Middle line"},
        )
        == "Side line top"
    )
    everything = {e.name for e in FIELD.elements}
    assert next_element(FIELD, drawn, "Big rect. left main", out_of_sight=everything) is None


def test_a_rectangle_is_gone_through_in_order_unless_much_more_is_to_be_had_elsewhere():
    group = [e.name for e in FIELD.elements if e.group == "Left penalty area"]
    gains = {**dict.fromkeys(group, 1.0), "Middle line": 1.9}
    drawn, order = [group[1]], [group[1]]
    for _ in group[1:]:
        following = next_element(FIELD, annotated(*drawn), order[-1], gains=gains)
        assert following is not None
        order.append(following)
        drawn.append(following)
    assert order == [*group[1:], group[0]]
    assert next_element(FIELD, annotated(*drawn), order[-1], gains=gains) == "Middle line"
    gains["Middle line"] = 2.0
    assert next_element(FIELD, annotated(group[1]), group[1], gains=gains) == "Middle line"
    assert next_element(FIELD, annotated(), None, gains=gains) == "Middle line"


# A few letters find what is meant, and little else.


@pytest.mark.parametrize(
    ("query", "name", "found"),
    [
        ("regall", "Regularise all elements", True),
        ("expover", "Export overview…", True),
        ("egall", "Regularise all elements", False),  # begins within a word
        ("rz", "Regularise all elements", False),
        ("open", "Zoom in", False),
    ],
)
def test_letters_in_order(query, name, found):
    assert (loose_rank(query, name) is not None) is found
    assert match_rank(query, name) is None


def test_what_fits_closer_comes_first():
    names = ["Snap", "Snap to lines", "Do snap", "Unsnap", "Send map"]
    ranks = [loose_rank("snap", name) for name in names]
    assert all(rank is not None for rank in ranks)
    assert ranks == sorted(ranks, key=lambda rank: -1 if rank is None else rank)
    assert len(set(ranks)) == len(names)


@pytest.mark.parametrize(
    ("query", "name", "found"),
    [
        ("regulraise", "Regularise all elements", True),
        ("dissagreement", "Next by disagreement", True),
        ("zoom", "Boom", False),
        ("undo", "Redo", False),
        ("regulraise qq", "Regularise all elements", False),
    ],
)
def test_misspelt_words(query, name, found):
    assert misspelt(query, name) is found
