"""What became of a dataset's landmarks: a table for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from rich.table import Table

from procc_annotator.session.landmarks.landmark_clicks import LocatedLandmark


def landmarks_table(located: Sequence[LocatedLandmark], described: str) -> Table:
    """One row a landmark, and an instant if it moves.

    Args:
        located: in the order of the rows.
        described: where the cameras come from.
    """
    table = Table(
        title="Landmarks", caption=described, title_justify="left", caption_justify="left"
    )
    table.add_column("landmark")
    table.add_column("instant")
    table.add_column("views", justify="right")
    table.add_column("position (x, y, z), m", justify="right")
    table.add_column("sd (x, y, z), m", justify="right")
    table.add_column("angle, deg", justify="right")
    table.add_column("off, px", justify="right")
    table.add_column("remark")
    for one in located:
        found = one.found
        kept = [px for frame, px in found.residuals_px if frame not in found.left_out]
        position, deviations = found.position, found.deviations_m
        table.add_row(
            one.clicked.name.strip(),
            one.clicked.instant or "",
            _views(one),
            "" if position is None else "{:.2f}, {:.2f}, {:.2f}".format(*position),
            "" if deviations is None else "{:.2f}, {:.2f}, {:.2f}".format(*deviations),
            f"{found.angle_degrees:.1f}" if position is not None else "",
            f"{max(kept):.1f}" if kept and (one.kept or position is not None) else "",
            "; ".join(_remarks(one)),
        )
    return table


def frames_without_camera(located: Sequence[LocatedLandmark]) -> dict[str, str]:
    """Frame -> why it took no part; each frame once, whatever was clicked in it."""
    return {frame: why for one in located for frame, why in one.without_view}


def surveyed_astray(located: Sequence[LocatedLandmark]) -> list[str]:
    """One sentence for each surveyed place that its clicks contradict."""
    return [
        f"{one.clicked.name.strip()} was surveyed, but its clicks are elsewhere: {_far(one)} (is it"
        " the same place, and are the position and the cameras right?)"
        for one in located
        if one.astray
    ]


def _far(one: LocatedLandmark) -> str:
    px = dict(one.found.residuals_px)
    return ", ".join(
        f"{px[frame]:.0f} px off in {frame}" if frame in px else f"{frame} does not show the place"
        for frame in one.astray
    )


def _views(one: LocatedLandmark) -> str:
    clicked = len(one.clicked.clicks)
    without = len(one.without_view)
    return f"{clicked - without} of {clicked}" if without else str(clicked)


def _remarks(one: LocatedLandmark) -> list[str]:
    found = one.found
    if found.position is None:
        return [found.failure or "", *(["the clicks do not agree"] if one.astray else [])]
    away = dict(found.residuals_px)
    return [f"left out: {frame} ({away[frame]:.0f} px off)" for frame in found.left_out]
