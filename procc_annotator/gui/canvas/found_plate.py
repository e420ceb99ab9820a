"""What was found of the frame's camera without clicks, on a plate in the corner of the picture."""

from __future__ import annotations

from PySide6.QtCore import QRect

from procc_annotator.assist.track_anchors import CameraCorrection
from procc_annotator.calibration.single_image.proposal import NONE, SURE
from procc_annotator.gui.canvas.split_view import NamePlate
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.soon import soon
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.interaction import palette as tones
from procc_annotator.translation import tr, tr_count

_MARGIN = 8
_GREY = tones.UNKNOWN_CLASS


class FoundPlate(NamePlate):
    """Says whether a camera is looked for, sure, unsure or none, and why; in words and colour."""

    def __init__(self, document: Document, view: PictureView) -> None:
        super().__init__(view.viewport(), "foundPlate")
        self._document, self._viewport = document, view.viewport()
        self._soon = soon(self, self._show)
        document.foresight.changed.connect(self._soon.start)
        document.store.watch(lambda s: (select.annotation(s), select.mode(s)), self._soon.start)
        view.resized.connect(self._stand)

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
        width = min(self.wanted_size().width(), self._room())
        height = self.wanted_height(width)
        top = self._viewport.height() - height - _MARGIN
        self.put(QRect(_MARGIN, top, width, height))

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
                return tr("Camera of the track, unsure: {why}", why=doubt), tones.UNSURE_GHOST
            return tr("Camera of the track: Shift+Enter accepts its elements"), tones.PASSES
        if document.proposals.working:
            return tr("Looking for the camera in the picture …"), _GREY
        proposal = document.proposals.here
        if proposal is None:
            return None
        why = proposal.reason
        if proposal.state == NONE:
            return tr("No camera found: {why}", why=why), _GREY
        if proposal.state == SURE:
            return tr("Camera found, sure: {why}", why=why), tones.PASSES
        return tr("Camera found, unsure: {why}", why=why), tones.UNSURE_GHOST


def _of_corrected(corrected: CameraCorrection, *, looking: bool) -> tuple[str, str]:
    pegs = tr_count(len(corrected.pegs), "{n} peg", "{n} pegs")
    if not corrected.looked:
        if looking:
            return tr("Camera dragged, {pegs}: its lines are looked for …", pegs=pegs), _GREY
        return tr("Camera dragged, {pegs}", pegs=pegs), _GREY
    if corrected.why_not:
        why = corrected.why_not
        text = tr("Camera dragged, {pegs}, not made exact: {why}", pegs=pegs, why=why)
        return text, tones.UNSURE_GHOST
    text = tr(
        "Camera dragged, {pegs}, made exact on paint: {share:.0%} of its lines",
        pegs=pegs,
        share=corrected.coverage,
    )
    return text, tones.PASSES
