"""Which element an annotator most likely draws next."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Element, Field
from procc_annotator.field.neighbours import distances_from, touching_elements

# A rectangle is left for an element elsewhere that would bring so many times as much.
_WORTH_LEAVING = 2.0


def next_element(
    field: Field,
    annotation: FrameAnnotation,
    finished: str | None,
    seen_before: Collection[str] = (),
    *,
    gains: Mapping[str, float] | None = None,
    out_of_sight: Collection[str] = (),
) -> str | None:
    """The class to offer after one was finished; None when every element in sight is annotated.

    Where a camera tells what annotating each element would bring, the group of the finished one
    (the lines of a penalty area) is gone through in the field's order, from it on and round, unless
    an element elsewhere brings at least twice as much. Without a camera, if the frame annotated
    before this one had the finished element too (the camera moved little), its other elements come
    first. Then come those of the same group, then those that meet the finished one, then the
    nearest on the field. Elements on the ground come before goals at the same rank, optional ones,
    which a set need not have, come only where the frame before had them too.

    Args:
        field: knows groups and distances.
        annotation: classes with points are not offered, unconfirmed ones are (they wait for a
            hand).
        finished: the class just drawn; None at the beginning of a frame.
        seen_before: classes of the frame annotated last.
        gains: what the classes in sight would tell a fitted camera, px; none where none of them
            is worth a word.
        out_of_sight: classes known not to be in the picture; they are not offered.
    """
    done = {*annotation.annotated, *out_of_sight}
    candidates = [e for e in field.elements if e.name not in done and e.name != finished]
    if not candidates:
        return None
    element = field.element(finished or "")
    gains = gains or {}
    if telling := [e for e in candidates if e.name in gains]:
        return _most_telling(telling, element, field, gains).name
    if element is None:
        likely = [e.name for e in candidates if e.name in seen_before]
        return likely[0] if likely else None
    alike = seen_before if finished in seen_before else ()
    candidates = [e for e in candidates if not e.optional or e.name in alike]
    if not candidates:
        return None
    return _nearest(candidates, element, field, alike).name


def _most_telling(
    candidates: Sequence[Element],
    finished: Element | None,
    field: Field,
    gains: Mapping[str, float],
) -> Element:
    """The next one of the group of what was finished, or what brings much more."""
    best = max(candidates, key=lambda e: gains[e.name])
    own = [e for e in candidates if finished is not None and e.group == finished.group]
    if finished is None or not own:
        return best
    count, begin = len(field.elements), field.index[finished.name] + 1
    following = min(own, key=lambda e: (field.index[e.name] - begin) % count)
    much = gains[best.name] >= _WORTH_LEAVING * gains[following.name]
    return best if much and gains[best.name] > 0 else following


def _nearest(
    candidates: Sequence[Element], finished: Element, field: Field, alike: Collection[str]
) -> Element:
    """Of some elements the one that goes best with what was finished; ``alike``: also drawn in a
    frame like this one."""
    distance = distances_from(field, (finished.name,))
    touching = touching_elements(field, finished.name)

    def rank(one: Element) -> tuple[bool, bool, bool, bool, float]:
        return (
            one.name not in alike,
            one.group != finished.group,
            one.name not in touching,
            not one.on_ground,
            float(distance[field.index[one.name]]),
        )

    return min(candidates, key=rank)
