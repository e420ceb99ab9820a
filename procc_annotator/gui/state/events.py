"""Events of the application that are no part of its state, as Qt signals."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal


class Events(QObject):
    """Events of the store; a change of the state is no event, but watched (`Store.watch`).

    Attributes:
        frameLeft: the frame on screen is about to be left: set aside what is being drawn.
        aboutToLeave: something else is about to be done: finish what is in progress.
        flyTo: show this position of the picture (px).
        flyToArea: show this part of the picture (px: left, top, right, bottom).
        annotationEdited: the annotation on screen was edited, or its file was read again.
        framesEdited: annotations of frames (a list of indices) that need not be on screen.
        frameScoresChanged: JaC of one frame, or of all of them ("").
        sourceAuditsChanged: more is known of the scores of a source in the frames of the dataset.
    """

    frameLeft = Signal()
    aboutToLeave = Signal()
    flyTo = Signal(float, float)
    flyToArea = Signal(float, float, float, float)
    annotationEdited = Signal()
    framesEdited = Signal(list)
    frameScoresChanged = Signal(str)
    sourceAuditsChanged = Signal(object)
    message = Signal(object)
