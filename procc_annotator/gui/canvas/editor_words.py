"""What is said of the work of hands on the picture."""

from __future__ import annotations

from procc_annotator.translation import tr, tr_count


def why_not_deleted(title: str, dropped: int) -> str:
    """Why no element was deleted, or what was taken back instead.

    Args:
        title: of the chosen element; empty for none.
        dropped: how many points were under way of it.
    """
    if not title:
        return tr("choose the element to delete first: field map, list, or its key")
    if dropped:
        return tr_count(
            dropped, "dropped {n} point of {title}", "dropped {n} points of {title}", title=title
        )
    return tr("{title} has no points in this frame: choose the element to delete", title=title)


def waiting(title: str, frame: str) -> str:
    """That a single click on an element was kept as its frame was left."""
    return tr(
        "kept 1 click of {title} on {frame}, unconfirmed: choose the element there to go on",
        title=title,
        frame=frame,
    )


def finished(title: str, count: int, frame: str) -> str:
    """That an element was finished with so many points as its frame was left."""
    if not frame:
        return tr_count(
            count,
            "finished {title} with {n} point",
            "finished {title} with {n} points",
            title=title,
        )
    return tr_count(
        count,
        "finished {title} with {n} point on {frame}",
        "finished {title} with {n} points on {frame}",
        title=title,
        frame=frame,
    )
