"""The program in a desktop's menus: what is installed, that tools accept it, that it goes again."""

import configparser
import re
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import cv2
import pytest

from procc_annotator.cli import desktop_entry

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="of Linux")
ID = "org.procc.Annotator"


@pytest.fixture
def home(tmp_path, monkeypatch) -> Path:
    """A user's data folder, with something of another program in it."""
    folder = tmp_path / "own data"
    (folder / "applications").mkdir(parents=True)
    (folder / "applications" / "other.desktop").write_text("[Desktop Entry]\n")
    monkeypatch.setenv("XDG_DATA_HOME", str(folder))
    return folder


def files(folder: Path) -> set[str]:
    """What is there but for the caches that a desktop's tools make."""
    made = {"mimeinfo.cache", "icon-theme.cache", "index.theme"}
    found = (p for p in folder.rglob("*") if p.is_file() and p.name not in made)
    own = {str(p.relative_to(folder)) for p in found}
    return {n for n in own if not re.match(r"mime/(?!packages/)", n)}


def test_everything_is_installed_and_removed_and_nothing_else_is_touched(cli, home):
    cli("desktop-entry", "--install")
    icons = {f"icons/hicolor/{s}x{s}/apps/{ID}.png" for s in (16, 24, 32, 48, 64, 128, 256, 512)}
    assert files(home) == icons | {
        "applications/other.desktop", f"applications/{ID}.desktop", f"mime/packages/{ID}.xml",
        f"metainfo/{ID}.metainfo.xml", f"icons/hicolor/scalable/apps/{ID}.svg",
    }  # fmt: skip
    for icon in icons:
        size = int(icon.split("/")[2].partition("x")[0])
        assert cv2.imread(str(home / icon), cv2.IMREAD_UNCHANGED).shape == (size, size, 4)
    cli("desktop-entry", "--install")  # again, after an update
    assert "(there)" in cli("desktop-entry").stdout
    cli("desktop-entry", "--remove")
    assert files(home) == {"applications/other.desktop"}
    cli("desktop-entry", "--remove")
    cli("desktop-entry", "--install", "--remove", code=2)


def test_the_entry_starts_this_installation_whatever_its_path_is_like(
    cli, home, tmp_path, monkeypatch
):
    place = tmp_path / 'a "b" $c 100% \\ d'
    place.mkdir()
    (place / "procc-annotator-window").touch()
    monkeypatch.setattr(desktop_entry.sys, "executable", str(place / "python"))
    cli("desktop-entry", "--install")
    entry = configparser.RawConfigParser()
    entry.optionxform = str
    entry.read(home / "applications" / f"{ID}.desktop", encoding="utf-8")
    command = entry["Desktop Entry"]["Exec"].replace("\\\\", "\\")  # as of every string there
    quoted, placeholder = command.rsplit(" ", 1)
    assert (quoted[0], quoted[-1], placeholder) == ('"', '"', "%f")
    program = re.sub(r"\\(.)", r"\1", quoted[1:-1]).replace("%%", "%")
    assert program == str(place / "procc-annotator-window")


def test_the_tools_of_desktops_accept_the_files(cli, home):
    cli("desktop-entry", "--install")
    checks = {
        "desktop-file-validate": ("applications", ".desktop", []),
        "appstreamcli": ("metainfo", ".metainfo.xml", ["validate", "--no-net"]),
    }
    tried = 0
    for tool, (folder, suffix, options) in checks.items():
        if (program := shutil.which(tool)) is not None:
            command = [program, *options, str(home / folder / f"{ID}{suffix}")]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            assert done.returncode == 0, done.stdout + done.stderr
            tried += 1
    package = ElementTree.parse(home / "mime" / "packages" / f"{ID}.xml").getroot()
    kind = package[0].get("type")
    entry = (home / "applications" / f"{ID}.desktop").read_text()
    assert f"{kind};" in entry.partition("MimeType=")[2]
    if not tried:
        pytest.skip("neither desktop-file-validate nor appstreamcli is installed")


def test_a_folder_that_cannot_be_written_is_one_line(cli, tmp_path, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "file"))
    done = cli("desktop-entry", "--install", code=2)
    assert len(done.stderr.splitlines()) == 1
