"""Whether another process of this machine still runs."""

from __future__ import annotations

import os
import sys
from contextlib import suppress


def machine_id() -> str:
    """Tells machines and containers of one name apart, and a machine before and after a restart.

    Empty where the system says nothing about it.
    """
    marks = []
    with suppress(OSError):  # Linux only
        with open("/proc/sys/kernel/random/boot_id", encoding="ascii") as file:
            marks.append(file.read().strip())
        marks.append(os.readlink("/proc/self/ns/pid"))  # a process id means nothing outside it
    return " ".join(marks)


if sys.platform == "win32":
    import ctypes

    def process_start(pid: int) -> str | None:
        """See below; ``os.kill(pid, 0)`` would end the process here."""
        query_limited_information, still_active, access_denied = 0x1000, 259, 5
        if not 0 < pid < 2**32:
            return None
        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.OpenProcess.restype = ctypes.c_void_p
        found = kernel.OpenProcess(query_limited_information, False, pid)
        if not found:
            return "" if ctypes.get_last_error() == access_denied else None
        handle = ctypes.c_void_p(found)
        try:
            code = ctypes.c_ulong()
            kernel.GetExitCodeProcess(handle, ctypes.byref(code))
            if code.value != still_active:
                return None
            times = [ctypes.c_ulonglong() for _ in range(4)]
            kernel.GetProcessTimes(handle, *(ctypes.byref(moment) for moment in times))
            return str(times[0].value)
        finally:
            kernel.CloseHandle(handle)

else:

    def process_start(pid: int) -> str | None:
        """When a process of this machine began, as the system counts; None when there is no such.

        Two processes that had the same id one after the other differ in it. Empty where the system
        does not say when a process began.
        """
        if pid <= 0:
            return None
        try:
            os.kill(pid, 0)
        except (ProcessLookupError, OverflowError):
            return None
        except PermissionError:  # somebody else's
            pass
        try:
            with open(f"/proc/{pid}/stat", "rb") as file:
                # The name in brackets may itself hold spaces and brackets.
                fields = file.read().rpartition(b")")[2].split()
        except OSError:  # no /proc here, or it ended this moment
            return ""
        state, start = fields[0], fields[19]
        return None if state in (b"Z", b"X") else start.decode("ascii")
