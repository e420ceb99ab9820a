"""Points placed for the annotator in the background: regularising and copying."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QObject

from procc_annotator.annotation import Polyline
from procc_annotator.assist.copying import Copied, annotated_before, copy_along_track, copy_moved
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.assist.regularise import Regularised, regularise
from procc_annotator.dataset import editing
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.records import OriginKind, PointKey
from procc_annotator.field.geometry import Arc, Circle, Line
from procc_annotator.field.model import BAR
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask, Priority
from procc_annotator.gui.state.services import Services
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.line_snapping import snap_points_to_lines
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import tr, tr_count, translatable, translatable_count, word

_NOTHING_REGULARISED = word("nothing changed: regular already, or no painted line was found there")


# What is worked out -> what is said once the user took it back, and once the frame was left.
_REGULARISING, _COPYING = "regularising", "copying"
_TAKEN_BACK = {
    _REGULARISING: word("taken back: nothing is regularised"),
    _COPYING: word("taken back: nothing is copied"),
}
_LEFT = {
    _REGULARISING: word("the frame was left: nothing was regularised"),
    _COPYING: word("the frame was left: nothing was copied"),
}
_ALONG_TRACK = word("copied {what} from {frame}, along the track; Shift+V confirms all")
_MOVED = word("copied {what} from {frame}, moved with the camera; Shift+V confirms all")
_AS_THEY_WERE = word(
    "copied {what} from {frame}, as they were: no motion found; Shift+V confirms all"
)


def _with_unconfirmed(words: str, count: int) -> str:
    if not count:
        return words
    unconfirmed = tr_count(
        count, "{n} point unconfirmed by paint", "{n} points unconfirmed by paint"
    )
    return f"{words}; {unconfirmed}"


_Regularised = tuple[tuple[Polyline, Regularised], ...]  # elements before and after the edit


class Assistant(QObject):
    """Runs one piece of work at a time; an outcome that came too late is not applied."""

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._services = services
        self._work = LatestOnlyTask(
            self, lambda text: services.say(text, "warning"), priority=Priority.URGENT
        )
        self._doing = _REGULARISING  # what is worked out
        services.store.watch(select.frame, self._leave)

    # --- regularising ---------------------------------------------------------------------

    def regularise_element(self) -> None:
        """Resample the selected element along its painted line, or the one just finished."""
        services = self._services
        services.store.events.aboutToLeave.emit()
        annotation = services.state.annotation
        for name in (services.state.selection.last_finished, services.state.selected_class):
            polyline = annotation.get(name or "") or annotation.get_unconfirmed(name or "")
            if polyline is not None and polyline.points:
                self._regularise((polyline,))
                return
        services.say(tr("choose an annotated element first"))

    def regularise_named(self, name: str) -> None:
        """Resample the element of a class along its painted line."""
        self._services.store.events.aboutToLeave.emit()
        polyline = self._services.state.annotation.get(name)
        self._regularise((polyline,) if polyline is not None else ())

    def regularise_frame(self) -> None:
        """Resample all elements of the frame along their painted lines."""
        self._services.store.events.aboutToLeave.emit()
        self._regularise(self._services.state.annotation.polylines)

    def _regularise(self, polylines: tuple[Polyline, ...]) -> None:
        self._work.finish()  # what was asked for before is done first
        services, picture = self._services, self._services.navigator.picture
        field, size = services.state.field, services.state.picture_size
        # Smoothing would round the corners off, and a single place has no line.
        smooth = {e.name for e in field.elements if isinstance(e.geometry, Line | Arc | Circle)}
        given = [p for p in polylines if field.element(p.class_name) is not None]
        polylines = tuple(p for p in given if p.class_name in smooth)
        if given and not polylines:
            title = tr(field.title_of(given[0].class_name))
            services.say(
                tr("{element} has corners or is one place: it stays as it is", element=title)
            )
            return
        if not polylines:
            services.say(tr("no element of the field is annotated here"))
        if not polylines or not services.editing.begin_edit() or picture is None or size is None:
            return
        curved = {e.name for e in field.elements if e.is_curved}
        paint = ExpectedLines(field, size[0])

        def work(control: JobControl) -> _Regularised:
            def regular(p: Polyline) -> Regularised:
                sought = paint.of(p.class_name)
                return regularise(
                    p,
                    curved=p.class_name in curved,
                    size=size,
                    snap=partial(snap_points_to_lines, picture, sought=sought),
                    bar=sought.looks.kind == BAR,
                )

            return tuple((p, regular(p)) for p in polylines if not control.cancelled)

        self._doing = _REGULARISING
        self._work.start(work, self._apply_regularised)

    def _apply_regularised(self, outcome: _Regularised) -> None:
        services = self._services
        if not services.editing.begin_edit():
            return
        annotation = services.state.annotation
        done: list[Polyline] = []
        unseen: set[PointKey] = set()
        for before, after in outcome:
            # What was edited meanwhile is newer than this outcome.
            name = before.class_name
            now = annotation.get(name) or annotation.get_unconfirmed(name)
            if now != before:
                continue
            unseen |= {(p.u, p.v) for p in after.unconfirmed}
            if after.polyline != before:
                annotation = annotation.with_polyline(after.polyline)
                done.append(after.polyline)
        if not done:
            services.editing.note_unseen(frozenset(unseen))
            services.say(_with_unconfirmed(tr(_NOTHING_REGULARISED), len(unseen)))
            return

        if len(done) == 1:
            what = translatable(services.state.field.title_of(done[0].class_name))
        else:
            what = translatable_count(len(done), "{n} element", "{n} elements")
        label = translatable("regularise {what}", what=what)
        if services.editing.commit_edit(
            label, annotation, OriginKind.REGULARISED, unseen=frozenset(unseen)
        ):
            points = sum(len(p.points) for p in done)
            words = tr_count(
                points, "regularised {what}: {n} point", "regularised {what}: {n} points", what=what
            )
            services.say(_with_unconfirmed(words, len(unseen)))

    # --- copying --------------------------------------------------------------------------

    def copy_from_previous(self) -> None:
        """Take over the elements of the nearest annotated frame before this one, moved as the
        camera moved; they wait for the user."""
        self._work.finish()
        services = self._services
        services.store.events.aboutToLeave.emit()
        workspace = services.state.workspace
        source = annotated_before(workspace, services.state.frame_index) if workspace else None
        picture, size = services.navigator.picture, services.state.picture_size
        if source is None:
            services.say(tr("no frame before this one is annotated"))
            return
        if not services.editing.begin_edit() or picture is None or size is None:
            return
        frame, annotation = source
        known = set(services.state.annotation.annotated)
        polylines = tuple(p for p in annotation.polylines if p.points and p.class_name not in known)
        if not polylines:
            services.say(tr("{frame} has no element that is missing here", frame=frame.name))
            return
        self._doing = _COPYING
        fit = services.shot_track.fit_here if services.proposals.allowed else None
        if fit is not None:
            here, field = services.state.annotation, services.state.sized_field
            self._work.start(
                lambda _: copy_along_track(polylines, here, picture, field, fit),
                partial(self._apply_copied, frame.name, polylines, along_track=True),
            )
            return
        self._copy_moved(frame, polylines, picture, size[0])

    def _copy_moved(
        self, frame: Frame, polylines: tuple[Polyline, ...], picture: PixelArray, width: int
    ) -> None:
        services = self._services
        kept = services.cache.peek(frame.image_path)

        def work(control: JobControl) -> Copied:
            previous = kept if kept is not None else decode_bgra(frame.image_path)
            return copy_moved(polylines, previous, picture, curved, paint, spots)

        elements = services.state.field.elements
        paint = ExpectedLines(services.state.field, width)
        curved = frozenset(e.name for e in elements if e.is_curved)
        spots = frozenset(e.name for e in elements if e.is_spot)
        self._work.start(work, partial(self._apply_copied, frame.name, polylines))

    def _apply_copied(
        self,
        source: str,
        wanted: tuple[Polyline, ...],
        outcome: Copied,
        *,
        along_track: bool = False,
    ) -> None:
        services = self._services
        if not services.editing.begin_edit():
            return
        proposed = editing.add_unconfirmed(services.state.annotation, outcome.polylines)
        label = translatable("copy from {frame}", frame=source)
        if services.editing.commit_edit(label, proposed, OriginKind.COPIED, unseen=outcome.unseen):
            selected = services.state.selected_class or ""
            unconfirmed = services.state.annotation.get_unconfirmed(selected)
            if outcome.polylines and unconfirmed is None:  # Enter confirms it
                services.selection.select_class(outcome.polylines[0].class_name)
            what = tr_count(len(outcome.polylines), "{n} element", "{n} elements")
            how = _ALONG_TRACK if along_track else _MOVED if outcome.moved else _AS_THEY_WERE
            words = _with_unconfirmed(tr(how, what=what, frame=source), len(outcome.unseen))
            services.say("; ".join(filter(None, (words, self._left_out(wanted, outcome)))))

    def _left_out(self, wanted: tuple[Polyline, ...], outcome: Copied) -> str:
        done, index = {p.class_name for p in outcome.polylines}, self._services.state.field.index
        elements = self._services.state.field.elements
        names = [p.class_name for p in wanted if p.class_name not in done]
        titles = [elements[index[name]].title if name in index else name for name in names]
        if not titles:
            return ""
        return tr(
            "left out, not in the picture or no line seen: {elements}", elements=", ".join(titles)
        )

    # --- second thoughts ------------------------------------------------------------------

    def key(self, name: str, _shift: bool) -> bool:
        """Take Escape or Undo while something is worked out: it is what they take back."""
        if name not in ("Escape", "Undo") or not self._work.cancel():
            return False
        self._services.say(tr(_TAKEN_BACK[self._doing]))
        return True

    def _leave(self) -> None:
        if self._work.cancel():
            self._services.say(tr(_LEFT[self._doing]))
