"""Selections of the state that several watches share: pure functions for `Store.watch`."""

from __future__ import annotations

from operator import attrgetter

from procc_annotator.gui.state.state import State

dataset = attrgetter("workspace")
field = attrgetter("field")
blind = attrgetter("blind")
committed = attrgetter("committed")
selection = attrgetter("selection")
unsaved = attrgetter("unsaved")


def frame(state: State) -> tuple[object, ...]:
    """Return the frame on screen."""
    return state.workspace, state.frame_index


def annotation(state: State) -> tuple[object, ...]:
    """Return the frame on screen with its annotation, without a gesture in progress."""
    return state.workspace, state.frame_index, state.annotation


def picture(state: State) -> tuple[object, ...]:
    """Return the frame on screen with its picture; half its size is shown first."""
    return state.workspace, state.frame_index, state.picture, state.half


def score(state: State) -> tuple[object, ...]:
    """Return what the score of the frame on screen depends on, without a gesture in progress."""
    settings = state.setup, state.tau, state.noise_floor, state.projection_visible
    shown = annotation(state), state.counts, state.damage
    return shown, settings, state.active, state.active_cameras


def judged(state: State) -> tuple[object, ...]:
    """Return what the verdicts on the frame on screen depend on, with a gesture in progress."""
    shown = state.workspace, state.frame_index, state.shown_annotation, state.why_not_judged
    settings = state.setup, state.tau, state.projection_visible
    return shown, settings, state.active, state.active_cameras


def cameras(state: State) -> tuple[object, ...]:
    """Return how the camera sources are listed and drawn, and which are active and compared.

    Cameras fitted to the clicks change with every edit and are left out.
    """
    looks = tuple(
        (k.source, k.name, k.colour, k.visible, k.cameras if k.source.files is not None else None)
        for k in state.looks
    )
    return looks, state.active, state.compared


def mode(state: State) -> tuple[object, ...]:
    """Return what a click does, and whether the frame on screen can be edited."""
    can_edit = state.holder, state.damage, state.picture_error
    return state.mode, state.options, state.blind, state.blind_lock, can_edit
