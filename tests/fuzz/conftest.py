"""What the fuzz tests share: the judge of every input, damage by bytes, and the tally at the end.

Every input is reproducible: hypothesis and byte damage go by the number of the lap (`make soak`).
"""

import random
import re
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

import pytest
from hypothesis import HealthCheck, settings

from procc_annotator.errors import InputError, ProccError

T = TypeVar("T")
_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_TOKENS = (
    *(b"NaN", b"-Infinity", b"1e999", b"-1e999", b"1e-400", b"-0", b"-0.0", b"1E5", b"0.1e-1"),
    *(b"9" * 400, b"9" * 5000, b"0." + b"3" * 400, b"2" * 19, b"9007199254740993"),
    *(b"null", b"true", b'"1"', b"[]", b"{}", b"[" * 70 + b"]" * 70, b"01", b"+1", b".5", b"1."),
    *(b"0x10", b"1_0", b'"\\ud83d"', b"\x00", b"\xff", b"\xef\xbb\xbf", b"\r\n", b",", b":", b'"'),
)
_BYTES = (0, 1, 9, 10, 32, 34, 44, 45, 48, 58, 91, 93, 92, 123, 125, 127, 128, 192, 255)


@dataclass
class _Kind:
    inputs: int = 0
    refused: int = 0
    seconds: float = 0.0
    worst_seconds: float = 0.0


@dataclass
class Judge:
    """Runs a reader on one input and holds it to the promises every reader makes."""

    kinds: dict[str, _Kind] = field(default_factory=dict)

    def __call__(
        self, kind: str, name: str, read: Callable[[], T], *, again: bool = False
    ) -> T | None:
        """What is read; None when it is refused. Anything but a clear refusal fails the test.

        ``again``: the same input is read in another way, and not counted twice.
        """
        entry = self.kinds.setdefault(kind, _Kind())
        entry.inputs += not again
        started = time.perf_counter()
        try:
            return read()
        except ProccError as error:
            entry.refused += not again
            _check_refusal(error, name)
            return None
        finally:
            seconds = time.perf_counter() - started
            entry.seconds += seconds
            entry.worst_seconds = max(entry.worst_seconds, seconds)


def _check_refusal(error: ProccError, name: str) -> None:
    text = str(error)
    assert name in text, "the error does not name the file"
    assert text.isprintable(), "more than one line, or something a terminal obeys"
    assert len(text) < len(name) + 600, "too long to be read"
    assert isinstance(error, InputError)
    assert error.problem


def damaged(name: str, seeds: Sequence[bytes], numbers: Iterable[int]) -> Iterator[bytes]:
    """Valid files with bytes changed, put in, left out, numbers replaced, or cut off."""
    for number in numbers:
        chance = random.Random(f"{name} {number}")
        data = chance.choice(seeds)
        for _ in range(chance.choice((1, 1, 1, 1, 2, 5))):
            data = _damage_once(chance, data, seeds)
        yield data


def _damage_once(chance: random.Random, data: bytes, seeds: Sequence[bytes]) -> bytes:
    at = chance.randrange(len(data) + 1)
    to = min(len(data), at + chance.choice((1, 1, 2, 8, 64)))
    match chance.randrange(10):
        case 0:  # a bit flips
            flipped = bytes(b ^ 1 << chance.randrange(8) for b in data[at : at + 1])
            return data[:at] + flipped + data[at + 1 :]
        case 1:
            return data[:at] + bytes([chance.choice(_BYTES)]) + data[at + 1 :]
        case 2:
            return data[:at] + chance.choice(_TOKENS) + data[at:]
        case 3:
            return data[:at] + data[to:]
        case 4:  # something stands there twice
            return data[:to] + data[at:to] + data[to:]
        case 5:
            return data[:at]
        case 6:  # the end of another file
            other = chance.choice(seeds)
            return data[:at] + other[chance.randrange(len(other)) :]
    numbers = list(_NUMBER.finditer(data))
    if not numbers:
        return data + chance.choice(_TOKENS)
    found = chance.choice(numbers)
    new = chance.choice(_TOKENS) if chance.random() < 0.4 else _other_number(chance)
    return data[: found.start()] + new + data[found.end() :]


def _other_number(chance: random.Random) -> bytes:
    """Nearly always one that is accepted, so that keeping it unchanged is tested as well."""
    match chance.randrange(4):
        case 0:
            return str(chance.randrange(-(10**6), 10**6)).encode()
        case 1:
            return repr(chance.uniform(-2, 2)).encode()
        case 2:
            return f"{chance.uniform(-1, 1):.{chance.randrange(20, 40)}e}".encode()
    return f"{chance.random():.{chance.randrange(1, 30)}f}".encode()


@pytest.fixture
def damage(lap) -> Callable[[str, Sequence[bytes], int], Iterator[bytes]]:
    return lambda name, seeds, count: damaged(name, seeds, range(lap * count, (lap + 1) * count))


@pytest.fixture(scope="session")
def judge(request) -> Judge:
    return request.config.stash[_JUDGE]


_JUDGE = pytest.StashKey[Judge]()


def pytest_configure(config: pytest.Config) -> None:
    config.stash[_JUDGE] = Judge()
    settings.register_profile(
        "fuzz",
        database=None,
        deadline=None,
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
    )


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    kinds = config.stash[_JUDGE].kinds
    if not kinds:
        return
    total = sum(k.inputs for k in kinds.values())
    terminalreporter.write_line(f"fuzz: {total} inputs")
    for name, k in sorted(kinds.items()):
        terminalreporter.write_line(
            f"  {name}: {k.inputs} inputs, {k.refused} refused, {k.seconds:.1f} s,"
            f" worst {1000 * k.worst_seconds:.1f} ms"
        )
