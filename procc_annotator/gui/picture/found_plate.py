"""What was found of the frame's camera without clicks, on a plate in the corner of the picture."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QRect, QTimer
from PySide6.QtWidgets import QWidget

from procc_annotator.fit.from_picture.proposal import NONE, SURE
from procc_annotator.gui.picture.split_view import NamePlate
from procc_annotator.gui.state.document import Document
from procc_annotator.interact import palette as tones
from procc_annotator.interact.hints import counted
from procc_annotator.session.clicks.correction import Correction

_MARGIN = 8
_GREY = tones.UNKNOWN_CLASS


class FoundPlate(NamePlate):
    """Says whether a camera is looked for, sure, unsure or none, and why; in words and colour."""

    def __init__(self, document: Document, viewport: QWidget) -> None:
        super().__init__(viewport, "foundPlate")
        self._document, self._viewport = document, viewport
        self._soon = QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self._show)
        for signal in (
            document.foresight.changed,
            document.frameChanged,
            document.annotationChanged,
            document.modeChanged,
        ):
            signal.connect(self._soon.start)
        viewport.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._stand()
        return False

    def _show(self) -> None:
        said = self._words()
        self.setVisible(said is not None)
        if said is not None:
            text, tone = said
            self.say(text, tone)
            if self.wanted_size().width() > self._room():
                self.say(text.partition(" (")[0], tone)  # the figures give way to the reason
            self._stand()

    def _room(self) -> int:
        return self._viewport.width() - 2 * _MARGIN

    def _stand(self) -> None:
        size = self.wanted_size()
        width = min(size.width(), self._room())
        top = self._viewport.height() - size.height() - _MARGIN
        self.put(QRect(_MARGIN, top, width, size.height()))

    def _words(self) -> tuple[str, str] | None:
        """Text and colour; None where there is nothing to say."""
        document = self._document
        state, foresight = document.state, document.foresight
        if state.frame is None or not document.proposals.allowed:
            return None
        stands_in = foresight.stands_in or document.corrections.rules
        if state.annotation.annotated and not stands_in:
            return None  # the clicks say more
        if (corrected := document.corrections.here) is not None:
            return _of_corrected(corrected, looking=document.corrections.looking)
        if document.shot_track.fit_here is not None:
            doubt = foresight.doubt
            if doubt:
                return f"Camera of the track, unsure: {doubt}", tones.UNSURE_GHOST
            return "Camera of the track: Shift+Enter accepts its elements", tones.PASSES
        if document.proposals.working:
            return "Looking for the camera in the picture …", _GREY
        proposal = document.proposals.here
        if proposal is None:
            return None
        if proposal.state == NONE:
            return f"No camera found: {proposal.reason}", _GREY
        if proposal.state == SURE:
            return f"Camera found, sure: {proposal.reason}", tones.PASSES
        return f"Camera found, unsure: {proposal.reason}", tones.UNSURE_GHOST


def _of_corrected(corrected: Correction, *, looking: bool) -> tuple[str, str]:
    pegs = counted(len(corrected.pegs), "peg")
    if not corrected.looked:
        then = ": its lines are looked for …" if looking else ""
        return f"Camera dragged, {pegs}{then}", _GREY
    if corrected.why_not:
        return f"Camera dragged, {pegs}, not made exact: {corrected.why_not}", tones.UNSURE_GHOST
    return (
        f"Camera dragged, {pegs}, made exact on paint: {corrected.coverage:.0%} of its lines",
        tones.PASSES,
    )
