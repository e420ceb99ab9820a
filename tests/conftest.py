"""Fixtures shared by all tests; what `make soak` repeats, and how long it may take."""

from __future__ import annotations

import atexit
import ctypes
import gc
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

# Before NumPy is loaded, as the program does: several processes share the machine's processors. Nor
# does OpenCV divide small pictures among threads that wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("OPENCV_FOR_THREADS_NUM", "1")

import hypothesis
import numpy as np
import pytest
from hypothesis import HealthCheck, settings

import procc_annotator.gui  # noqa: F401  (before pytest-qt: or the source of all modules is read)

if TYPE_CHECKING:
    from procc_annotator.annotation import FrameAnnotation
    from procc_annotator.calibration.label_check.finding import Finding

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
# Not the user's; one for all processes of a run, which inherit it from the first one.
if "PROCC_TESTS_CACHE" not in os.environ:
    os.environ["PROCC_TESTS_CACHE"] = tempfile.mkdtemp(prefix="procc-tests-cache-")
    atexit.register(shutil.rmtree, os.environ["PROCC_TESTS_CACHE"], ignore_errors=True)
os.environ["XDG_CACHE_HOME"] = os.environ["PROCC_TESTS_CACHE"]

# The same examples in every run, and none that fails because the machine is busy; a taste of them:
# `make soak` goes on with others.
settings.register_profile(
    "shared_machine",
    derandomize=True,
    max_examples=30,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("shared_machine")

ROOT = Path(__file__).resolve().parent.parent


# One long test alone at the end would be waited for: these begin first, the many short files last.
# So does what takes much memory for a moment, and would take it on top of what was loaded before.
LONG = (
    "tests/unit/formats/test_kill.py",  # forks: slow in a large process
    "tests/unit/image/test_decode.py",
    "tests/unit/formats/test_matlab_file.py",
    "tests/test_sample_data.py",
    "tests/fuzz/test_damaged",
    "tests/gui/test_random_use.py",
    "tests/unit/calibration/joint/test_field_dimensions.py",
    "tests/data/",
    "tests/cli/test_track.py",
)
# `make soak`: how often properties, and tests marked `laps`, are repeated, each time with other
# random choices.
SOAK = int(os.environ.get("SOAK", "1"))
BUDGET_OVER = "the time for this run is used up"
_USED = pytest.StashKey[list[tuple[int, float]]]()  # of each process: peak memory, MB; CPU, s
_ENDS = pytest.StashKey[float | None]()
# Files of tests lie in memory where there is room: most of what a window waits for else is a disk
# that is asked to have everything written.
_IN_MEMORY, _FILES_BYTES = Path("/dev/shm"), 2**31
_FOLDERS = "procc-tests-"
_FOLDER = pytest.StashKey[str | None]()
_FAILED = pytest.StashKey[bool]()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--budget", type=float, help="seconds after which no further test begins")


@pytest.hookimpl(tryfirst=True)  # before pytest chooses a folder itself
def pytest_configure(config: pytest.Config) -> None:
    config.stash[_FOLDER], config.stash[_FAILED] = None, False
    if config.option.basetemp is None and _has_room(_IN_MEMORY):
        config.stash[_FOLDER] = config.option.basetemp = _folder_in_memory()
    # pytest-xdist puts the files with the fewest tests last; those are the long ones here.
    if hasattr(config.option, "loadscopereorder"):
        config.option.loadscopereorder = False
    config.stash[_USED] = []
    budget = config.getoption("budget")
    started = getattr(config, "workerinput", {}).get("started", time.time())
    config.stash[_ENDS] = None if budget is None else started + budget


def _has_room(folder: Path) -> bool:
    return os.access(folder, os.W_OK) and shutil.disk_usage(folder).free > _FILES_BYTES


def _folder_in_memory() -> str:
    """A new folder for this process; those that earlier runs left there go."""
    for left in _IN_MEMORY.glob(f"{_FOLDERS}*"):
        if not Path("/proc", left.name.removeprefix(_FOLDERS).partition("-")[0]).exists():
            shutil.rmtree(left, ignore_errors=True)
    return tempfile.mkdtemp(prefix=f"{_FOLDERS}{os.getpid()}-", dir=_IN_MEMORY)


def pytest_unconfigure(config: pytest.Config) -> None:
    """Files of tests that failed can be looked at until the next run."""
    folder = config.stash[_FOLDER]
    if folder is not None and not config.stash[_FAILED]:
        shutil.rmtree(folder, ignore_errors=True)


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    node.workerinput["started"] = time.time()


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    is_property = hasattr(metafunc.function, "hypothesis")
    if is_property or metafunc.definition.get_closest_marker("laps"):
        metafunc.fixturenames.append("lap")
        laps = [pytest.param(n, marks=[pytest.mark.soak] if n else []) for n in range(SOAK)]
        metafunc.parametrize("lap", laps, ids="lap{}".format, indirect=True)


# The slowest quarter of the tests, which takes three quarters of the time: only in `make soak`.
# Tests that show that clicks are kept and numbers are right stay in `make test`, however long.
SLOW = frozenset((ROOT / "tests" / "slow.txt").read_text(encoding="utf-8").split())


def _is_slow(test: str) -> bool:
    names = test.partition("[")[0].split("::")
    return test in SLOW or any("::".join(names[:n]) in SLOW for n in range(1, len(names) + 1))


@pytest.hookimpl(tryfirst=True)  # before tests are selected by their marks
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if _is_slow(item.nodeid):
            item.add_marker(pytest.mark.soak)

    def place(item: pytest.Item) -> tuple[int, int]:
        lap = item.callspec.params.get("lap", 0) if hasattr(item, "callspec") else 0
        begins = (i for i, begin in enumerate(LONG) if item.nodeid.startswith(begin))
        return lap, next(begins, len(LONG))

    items.sort(key=place)


def pytest_runtest_setup(item: pytest.Item) -> None:
    ends = item.config.stash[_ENDS]
    if ends is not None and time.time() > ends:
        pytest.skip(BUDGET_OVER)


def pytest_sessionfinish(session: pytest.Session) -> None:
    session.config.stash[_FAILED] = session.testsfailed > 0
    if sys.platform == "win32":
        return
    import resource

    used = [resource.getrusage(resource.RUSAGE_SELF)]
    if not session.config.stash[_USED]:  # or its children are the workers, who told theirs
        used.append(resource.getrusage(resource.RUSAGE_CHILDREN))
    cpu_s = sum(u.ru_utime + u.ru_stime for u in used)
    mine = (used[0].ru_maxrss // 1024, cpu_s)
    session.config.stash[_USED].append(mine)
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["used"] = mine


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    if "used" in getattr(node, "workeroutput", {}):
        node.config.stash[_USED].append(tuple(node.workeroutput["used"]))


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    used = config.stash[_USED]
    cpu_s, megabytes = sum(s for _, s in used), ", ".join(str(mb) for mb, _ in used)
    terminalreporter.write_line(f"{cpu_s:.0f} s of CPU; at most {megabytes} MB in each process")
    if config.getoption("budget") is not None:
        skipped = terminalreporter.stats.get("skipped", [])
        left = [r.nodeid for r in skipped if BUDGET_OVER in str(r.longrepr)]
        done = sum(len(terminalreporter.stats.get(kind, [])) for kind in ("passed", "failed"))
        terminalreporter.write_line(
            f"{done} of {done + len(left)} tests began within {config.getoption('budget'):.0f} s"
            + (f"; not begun, from {left[0]}" if left else "")
        )


@pytest.fixture
def lap(request) -> int:
    """Which repetition this is, 0 in `make test`; what is random is chosen by it."""
    number: int = request.param
    if hasattr(request.function, "hypothesis"):
        hypothesis.seed(number)(request.function)
    return number


def pytest_collection_finish() -> None:
    """The tests themselves are no garbage: nobody looks through thousands of them again."""
    gc.collect()
    gc.freeze()


@pytest.fixture(scope="module", autouse=True)
def garbage_goes_between_modules(request) -> Iterator[None]:
    """What a module leaves goes, back to the system too; what stays, such as libraries, is not
    looked through again: that is 100 ms after each of hundreds of modules.

    As in the program, no thread but the interface's ends what Qt owns: garbage is looked for here
    only, where there are windows. There everything is looked through: windows stay, and go later.
    """
    has_windows = "gui" in request.path.parts or "interaction" in request.path.parts
    if has_windows:
        gc.disable()
    yield
    search = sys.modules.get("procc_annotator.calibration.single_image.search")
    if search is not None:  # for the next picture of the same field: 35 MB a side
        search.hypotheses_on_side.cache_clear()
        search.hypotheses_at_positions.cache_clear()
    gc.collect()
    gc.enable()
    if not has_windows:
        gc.freeze()
    _give_memory_back()


def _give_memory_back() -> None:
    with suppress(OSError, AttributeError, TypeError):  # another C library than glibc
        ctypes.CDLL(None).malloc_trim(0)


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Real annotations, cameras and official scores; they are not part of the project."""
    folder = ROOT.parent / "shared" / "data"
    if not folder.is_dir():
        pytest.skip(f"real data is not here: {folder} does not exist")
    return folder


@pytest.fixture(scope="session")
def world_cup(shared_data) -> list[FrameAnnotation]:
    """The annotations of World Cup 2014 by the names of their files."""
    from procc_annotator.field.load import load_field
    from procc_annotator.formats.annotations.soccernet import read_annotation

    paths = sorted((shared_data / "wc14" / "annotations").glob("*.json"))
    return [read_annotation(p.read_bytes(), path=str(p), field=load_field()) for p in paths]


@pytest.fixture(scope="session")
def sample_data() -> Path:
    """The project's own drawn frames."""
    return ROOT / "sample_data"


@pytest.fixture
def sample_copy(sample_data, tmp_path) -> Path:
    """The sample's frames of soccer and their cameras, to be changed at will."""
    folder = tmp_path / "sample"
    shutil.copytree(sample_data / "cameras", folder / "cameras")
    for path in sample_data.glob("0*.*"):
        shutil.copy(path, folder)
    return folder


@dataclass
class InjectedMistakes:
    """What the label check said of annotations that were made wrong on purpose."""

    frames: int = 0
    hit: int = 0  # wrong elements that were called so
    missed: int = 0
    false: int = 0  # right elements that were called wrong
    suggested: list[bool] = field(default_factory=list)
    each_second: list[float] = field(default_factory=list)

    @property
    def recall(self) -> float:
        return self.hit / (self.hit + self.missed)

    @property
    def precision(self) -> float:
        return self.hit / (self.hit + self.false)

    @property
    def right_suggestions(self) -> float:
        """Of the wrong elements that were found: those with the right label, or point, named."""
        return float(np.mean(self.suggested))

    @property
    def seconds(self) -> float:
        return float(np.mean(self.each_second))

    @property
    def most_seconds(self) -> float:
        return max(self.each_second)

    def count(self, findings: Sequence[Finding], wrong: dict[str, str | int]) -> None:
        """``wrong``: class -> the label it should have, or the index of its bad point."""
        errors = [f for f in findings if f.severity == "error"]
        named = {name for f in errors for name in f.elements}
        self.frames += 1
        self.hit += len(named & wrong.keys())
        self.missed += len(wrong.keys() - named)
        self.false += len(named - wrong.keys())
        for finding in errors:
            renamed = dict(finding.remedies[0].renamed)
            for name in wrong.keys() & set(finding.elements):
                right = wrong[name]
                said = renamed.get(name) if isinstance(right, str) else finding.point
                self.suggested.append(said == right)


@pytest.fixture(scope="session")
def injected_mistakes() -> Callable[..., InjectedMistakes]:
    """Makes one mistake in every annotation of at least six elements and checks the labels.

    Kinds: ``swapped`` (two labels), ``relabelled`` (one, to another class of its shape), ``posts``
    (of one goal, swapped) and ``point`` (one, moved 15 px across its line).
    """
    from procc_annotator.annotation import point_from_px, points_px
    from procc_annotator.calibration.fitting import fit_camera
    from procc_annotator.calibration.label_check.check import check_labels
    from procc_annotator.dataset import editing
    from procc_annotator.field.load import load_field

    soccer, size = load_field("soccer"), (960, 540)

    def swapped(annotation: FrameAnnotation, one: str, other: str):
        wrong: dict[str, str | int] = {one: other, other: one}
        return editing.swap_classes(annotation, one, other), wrong

    def spoiled(annotation: FrameAnnotation, kind: str, rng: np.random.Generator):
        names = [n for n in annotation.annotated if soccer.element(n) is not None]
        if kind == "swapped":
            return swapped(annotation, *map(str, rng.choice(names, 2, replace=False)))
        if kind == "posts":
            for goal in ("left", "right"):
                posts = [n for n in names if n.startswith(f"Goal {goal} post")]
                if len(posts) == 2:
                    return swapped(annotation, *posts)
            return None
        name = str(rng.choice(names))
        if kind == "relabelled":
            straight = soccer.element(name).is_straight
            free = [
                e.name
                for e in soccer.elements
                if e.name not in names and e.is_straight == straight and not e.optional
            ]
            if not free:
                return None
            new = str(rng.choice(free))
            return editing.change_class(annotation, name, new), {new: name}
        points = points_px(annotation.get(name), size)
        index = int(rng.integers(len(points)))
        along = points[index + 1 if index + 1 < len(points) else index - 1] - points[index]
        across = np.array([-along[1], along[0]]) / np.hypot(*along)
        x, y = points[index] + rng.choice([-15, 15]) * across
        moved = editing.move_point(annotation, name, index, point_from_px(x, y, size))
        return moved, {name: index}

    def measure(
        annotations: Sequence[FrameAnnotation], kind: str, *, seed: int
    ) -> InjectedMistakes:
        rng, found = np.random.default_rng(seed), InjectedMistakes()
        for annotation in annotations:
            if sum(soccer.element(n) is not None for n in annotation.annotated) < 6:
                continue
            made = spoiled(annotation, kind, rng)
            if made is None:
                continue
            wrong, truth = made
            fit = fit_camera(wrong, soccer)
            began = time.process_time()
            findings = check_labels(wrong, soccer, size=size, fit=fit)
            found.each_second.append(time.process_time() - began)
            found.count(findings, truth)
        return found

    return measure
