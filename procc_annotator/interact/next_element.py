"""Which element an annotator most likely draws next."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Element, Field
from procc_annotator.field.neighbours import distances_from, meeting


def next_element(
    field: Field,
    annotation: FrameAnnotation,
    finished: str | None,
    seen_before: Collection[str] = (),
    *,
    suggested: Sequence[str] = (),
    out_of_sight: Collection[str] = (),
) -> str | None:
    """The class to offer after one was finished; None when every element in sight is annotated.

    What a fitted camera suggests comes first. Without that, if the frame annotated before this one
    had the finished element too (the camera moved little), its other elements come first. Then come
    those of the same group, then those that meet the finished one, then the nearest on the field.
    Elements on the ground come before goals at the same rank, optional ones, which
    a set need not have, come only where the frame before had them too.

    Args:
        field: knows groups and distances.
        annotation: classes with points are not offered, unconfirmed ones are (they wait for a
            hand).
        finished: the class just drawn; None at the beginning of a frame.
        seen_before: classes of the frame annotated last.
        suggested: classes in sight that tell a fitted camera most, the best first.
        out_of_sight: classes known not to be in the picture; they are not offered.
    """
    done = {*annotation.annotated, *out_of_sight}
    candidates = [e for e in field.elements if e.name not in done and e.name != finished]
    if not candidates:
        return None
    offered = {e.name for e in candidates}
    if best := next((name for name in suggested if name in offered), None):
        return best
    if finished is None or (element := field.element(finished)) is None:
        likely = [e.name for e in candidates if e.name in seen_before]
        return likely[0] if likely else None
    alike = seen_before if finished in seen_before else ()
    candidates = [e for e in candidates if not e.optional or e.name in alike]
    if not candidates:
        return None
    return _nearest(candidates, element, field, alike).name


def _nearest(
    candidates: Sequence[Element], finished: Element, field: Field, alike: Collection[str]
) -> Element:
    """Of some elements the one that goes best with what was finished; ``alike``: also drawn in a
    frame like this one."""
    distance = distances_from(field, (finished.name,))
    touching = meeting(field, finished.name)

    def rank(one: Element) -> tuple[bool, bool, bool, bool, float]:
        return (
            one.name not in alike,
            one.group != finished.group,
            one.name not in touching,
            not one.on_ground,
            float(distance[field.index[one.name]]),
        )

    return min(candidates, key=rank)
