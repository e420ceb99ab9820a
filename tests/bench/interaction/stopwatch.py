"""Time from an action until the window is painted; the same for either program's Qt.

Reading the clocks takes time itself, on some machines half a millisecond: what an empty span takes
is measured first and taken off every span.

Knows neither binding, so that the interpreter of another program can import it.
"""

import json
import os
import statistics
import time
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

_GIVEN_UP_S = 5.0
_EMPTY = 200


class Stopwatch:
    """Takes wall time and the interface thread's own CPU time, ms.

    Whoever owns the window calls `painted` whenever it has been painted.
    """

    def __init__(self, process_events: Callable[[], object]) -> None:
        self._process_events = process_events
        self._begun: tuple[float, float] | None = None
        self._took: tuple[float, float] | None = None
        self._acted = False
        self.rows: dict[str, list[tuple[float, float]]] = defaultdict(list)
        self._own = (0.0, 0.0)
        for _ in range(_EMPTY):
            self.time("empty", lambda: None, paints=False)
        walls, cpus = zip(*self.rows.pop("empty"), strict=True)
        self._own = statistics.median(walls), statistics.median(cpus)

    def painted(self) -> None:
        """The window shows what there is to show."""
        if self._acted and self._begun is not None and self._took is None:
            wall, cpu = self._begun
            taken = (time.perf_counter() - wall) * 1e3, (time.thread_time() - cpu) * 1e3
            self._took = taken[0] - self._own[0], taken[1] - self._own[1]

    def time(self, row: str, act: Callable[[], object], *, paints: bool = True) -> None:
        """Do something once, and wait until it is seen (or not, where nothing is to be seen)."""
        self._took, self._acted = None, False
        self._begun = begin, _ = time.perf_counter(), time.thread_time()
        act()
        self._acted = True
        if not paints:
            self.painted()
        while self._took is None:
            if time.perf_counter() - begin > _GIVEN_UP_S:
                raise TimeoutError(f"{row}: nothing was painted")
            self._process_events()
        self.rows[row].append(self._took)

    def rest(self, until: Callable[[], bool] = lambda: True, least_s: float = 0.0) -> None:
        """Let everything happen that follows by itself."""
        begin = time.perf_counter()
        while not until() or time.perf_counter() - begin < least_s:
            self._process_events()
            time.sleep(0.001)
            if time.perf_counter() - begin > 60:
                raise TimeoutError("something never came to its end")

    def tell(self, **more: Any) -> None:
        """Print all rows as one line of JSON."""
        print(json.dumps({"rows": self.rows, "stopwatch": self._own, **more}), flush=True)


def resident_mb() -> float:
    """Memory of this process, MB (Linux)."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20
