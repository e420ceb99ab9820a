"""Install the system libraries that Qt needs, on Debian and Ubuntu, when they are missing.

Standard library only: it runs before anything is installed. Libraries are looked for by loading
them, not by package name, so a machine that has them from elsewhere is left alone.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import shutil
import subprocess
import sys

PACKAGES = {
    "libglib-2.0.so.0": "libglib2.0-0",
    "libGL.so.1": "libgl1",
    "libEGL.so.1": "libegl1",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libfreetype.so.6": "libfreetype6",
    "libfontconfig.so.1": "libfontconfig1",
    "libdbus-1.so.3": "libdbus-1-3",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-shape.so.0": "libxcb-shape0",
}  # Debian's


def missing_packages() -> list[tuple[str, ...]]:
    """Debian's names of the packages whose library cannot be loaded, alternatives together."""
    missing = []
    for library, package in PACKAGES.items():
        try:
            ctypes.CDLL(library)
        except OSError:
            missing.append((package,))
    if importlib.util.find_spec("ensurepip") is None:
        missing.append((f"python3.{sys.version_info.minor}-venv", "python3-venv"))
    return missing


def available(package: str) -> bool:
    found = subprocess.run(
        ["apt-cache", "show", package], capture_output=True, text=True, check=False
    )
    return found.returncode == 0 and bool(found.stdout.strip())


def main() -> int:
    missing = missing_packages()
    if not missing or not sys.platform.startswith("linux"):
        return 0
    if shutil.which("apt-get") is None:
        wanted = " ".join(names[-1] for names in missing)
        print(f"Qt needs libraries that are missing here. On Debian they are: {wanted}")
        print("Install your distribution's equivalents and run this again.")
        return 1
    root = os.geteuid() == 0
    sudo = [] if root else ["sudo", "-n"]
    may_install = root or (
        shutil.which("sudo") is not None
        and subprocess.run(["sudo", "-n", "true"], capture_output=True, check=False).returncode == 0
    )
    if not may_install:
        wanted = " ".join(names[-1] for names in missing)
        print("Qt needs system libraries that are missing. Please run this line, then try again:")
        print(f"  sudo apt-get update && sudo apt-get install -y {wanted}")
        return 1
    subprocess.run([*sudo, "apt-get", "update", "-qq"], check=False)
    chosen = [next((name for name in names if available(name)), names[-1]) for names in missing]
    print("Installing system libraries for Qt:", " ".join(chosen), flush=True)
    install = ["apt-get", "install", "-y", "-qq", "--no-install-recommends", *chosen]
    done = subprocess.run(
        [*sudo, "env", "DEBIAN_FRONTEND=noninteractive", *install],
        stdout=subprocess.DEVNULL,
        check=False,
    )
    if done.returncode != 0:
        print("That did not work. Please run this line, then try again:")
        print(f"  sudo apt-get update && sudo apt-get install -y {' '.join(chosen)}")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
