"""Pictures of every kind become the same kind of array, anything else one clear line."""

import json
import os
import struct
import zlib

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from procc_annotator.dataset.frames import list_frames
from procc_annotator.dataset.picture_sizes import PictureSizes, picture_size
from procc_annotator.dataset.sequence import open_pictures
from procc_annotator.errors import ImageError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.registry import SetReader
from procc_annotator.formats.file_source import open_source
from procc_annotator.image.decoding import decode_bgra, decode_thumbnail, read_size
from procc_annotator.image.headers import PICTURE_SUFFIXES, displayed_size, header_size

COLOUR = (40, 120, 200)  # b, g, r


def _encode(suffix: str, pixels: NDArray[np.generic]) -> bytes:
    done, data = cv2.imencode(suffix, pixels)
    assert done
    return data.tobytes()


def _plain(width: int, height: int) -> NDArray[np.uint8]:
    return np.full((height, width, 3), COLOUR, dtype=np.uint8)


def _turning_tiff(orientation: int) -> bytes:
    """What EXIF blocks hold."""
    tiff = b"II*\x00\x08\x00\x00\x00\x01\x00\x12\x01\x03\x00\x01\x00\x00\x00"
    return tiff + orientation.to_bytes(2, "little") + b"\x00\x00" + b"\x00\x00\x00\x00"


def _exif_jpeg(pixels: NDArray[np.uint8], orientation: int) -> bytes:
    """A JPEG with an EXIF block that says how the camera was held."""
    body = b"Exif\x00\x00" + _turning_tiff(orientation)
    data = _encode(".jpg", pixels)
    return data[:2] + b"\xff\xe1" + (len(body) + 2).to_bytes(2, "big") + body + data[2:]


def _exif_png(pixels: NDArray[np.uint8], *, behind: bool) -> bytes:
    """A PNG with EXIF data that turns it, before or behind the pixels."""
    data, tiff = _encode(".png", pixels), _turning_tiff(6)
    chunk = b"eXIf" + tiff
    chunk = struct.pack(">I", len(tiff)) + chunk + struct.pack(">I", zlib.crc32(chunk))
    place = data.rindex(b"IEND") - 4 if behind else 33
    return data[:place] + chunk + data[place:]


def _exif_webp(pixels: NDArray[np.uint8]) -> bytes:
    """A WebP with EXIF data that turns it, which come last."""
    height, width = pixels.shape[:2]
    sizes = (width - 1).to_bytes(3, "little") + (height - 1).to_bytes(3, "little")
    head = b"VP8X" + struct.pack("<I", 10) + b"\x08\x00\x00\x00" + sizes
    tiff = _turning_tiff(6)
    body = b"WEBP" + head + _encode(".webp", pixels)[12:]
    body += b"EXIF" + struct.pack("<I", len(tiff)) + tiff
    return b"RIFF" + struct.pack("<I", len(body)) + body


@pytest.mark.parametrize(
    "data",
    [
        _exif_jpeg(_plain(64, 36), 6),
        _exif_png(_plain(64, 36), behind=False),
        _exif_png(_plain(64, 36), behind=True),
        _exif_webp(_plain(64, 36)),
    ],
    ids=["jpg", "png", "png, behind the pixels", "webp"],
)
def test_the_size_is_that_of_the_turned_picture(tmp_path, data):
    path = tmp_path / "held_upright"
    path.write_bytes(data)
    assert picture_size(path) == (36, 64) == decode_bgra(path).shape[1::-1]


@pytest.mark.parametrize("suffix", [".jpg", ".png", ".bmp", ".webp"])
def test_most_sizes_are_known_without_decoding(tmp_path, suffix):
    path = tmp_path / "frame"
    path.write_bytes(_encode(suffix, _plain(64, 36)))
    with path.open("rb") as file:
        assert displayed_size(file) == (64, 36)


@pytest.mark.parametrize("suffix", sorted(PICTURE_SUFFIXES - {".jpeg", ".tif", ".pgm"}))
def test_colour_pictures_become_opaque_bgra(tmp_path, suffix):
    path = tmp_path / f"frame{suffix}"
    path.write_bytes(_encode(suffix, _plain(64, 36)))
    picture = decode_bgra(path)
    assert picture.shape == (36, 64, 4)
    assert picture.dtype == np.uint8
    assert picture.flags.c_contiguous
    assert not picture.flags.writeable
    of_256 = 50 if suffix == ".gif" else 4
    np.testing.assert_allclose(picture[18, 32], [*COLOUR, 255], atol=of_256)
    assert read_size(path) == (64, 36)


@pytest.mark.parametrize("suffix", [".png", ".tiff"])
def test_sixteen_bits_are_divided_down(tmp_path, suffix):
    path = tmp_path / f"deep{suffix}"
    path.write_bytes(_encode(suffix, _plain(8, 6).astype(np.uint16) * 257))
    np.testing.assert_array_equal(decode_bgra(path)[3, 4], [*COLOUR, 255])


def test_pictures_turned_by_exif_are_named_and_others_that_are_not_read(tmp_path):
    (tmp_path / "a.jpg").write_bytes(_exif_jpeg(_plain(64, 36), 6))
    (tmp_path / "b.jpg").write_bytes(_exif_jpeg(_plain(64, 36), 1))
    box = [{"id": 0, "name": "Middle line", "keypoints": ["1"]}]
    coco = {"images": [{"id": 1, "file_name": "a.jpg", "width": 64, "height": 36}],
            "annotations": [{"image_id": 1, "category_id": 0, "keypoints": [3, 4, 2]}],
            "categories": box}  # fmt: skip
    assert "1 frame (a): shown turned, as EXIF data" in list_frames(tmp_path)[2][0]
    (tmp_path / "coco.json").write_text(json.dumps(coco))
    with open_source(tmp_path / "coco.json") as source:
        sizes = PictureSizes([tmp_path]).size
        reader = SetReader(source, load_field("soccer"), size_of=sizes)
        assert "EXIF data turn these pictures (1 frame: a)" in reader.read_all().losses[0]
    (tmp_path / "c").mkdir()
    (tmp_path / "c/a.heic").write_bytes(b"0")
    for path in ("c", "c/a.heic"):
        with pytest.raises(UsageError, match=r"pictures in HEIC.*which is not read.*magick"):
            open_pictures(tmp_path / path)


def test_grey_of_netpbm_with_comments(tmp_path):
    for head, rows in (
        (b"P5 # it\n# is\n8\t6 255\n", bytes([77] * 48)),
        (b"P2 8 6 255\n", b"77 " * 48),
    ):
        (tmp_path / "grey.pgm").write_bytes(head + rows)
        np.testing.assert_array_equal(decode_bgra(tmp_path / "grey.pgm")[3, 4], [77, 77, 77, 255])


def test_grey_is_spread_over_the_channels(tmp_path):
    path = tmp_path / "grey.png"
    path.write_bytes(_encode(".png", np.full((6, 8), 77, dtype=np.uint8)))
    np.testing.assert_array_equal(decode_bgra(path)[3, 4], [77, 77, 77, 255])


def test_alpha_is_dropped(tmp_path):
    path = tmp_path / "alpha.png"
    pixels = np.dstack([_plain(8, 6), np.full((6, 8), 10, dtype=np.uint8)])
    path.write_bytes(_encode(".png", pixels))
    np.testing.assert_array_equal(decode_bgra(path)[3, 4], [*COLOUR, 255])


def test_a_picture_taken_upright_is_shown_upright(tmp_path):
    path = tmp_path / "portrait.jpg"
    pixels = np.zeros((32, 64, 3), dtype=np.uint8)
    pixels[:, :32] = 255
    path.write_bytes(_exif_jpeg(pixels, orientation=6))  # turn clockwise to view
    picture = decode_bgra(path)
    assert picture.shape == (64, 32, 4)
    assert picture[5, 16, 0] > 250
    assert picture[60, 16, 0] < 5
    assert read_size(path) == (32, 64)
    assert decode_thumbnail(path).shape == (64, 32, 4)


def test_names_may_hold_any_letters(tmp_path):
    path = tmp_path / "Größe 画像 №1.jpg"
    path.write_bytes(_encode(".jpg", _plain(64, 36)))
    assert decode_bgra(path).shape == (36, 64, 4)
    assert decode_thumbnail(path).shape == (36, 64, 4)


@pytest.mark.parametrize(
    ("size", "expected"),
    [
        ((1920, 1080), (160, 90)),
        ((1280, 720), (160, 90)),
        ((640, 480), (160, 120)),
        ((200, 400), (80, 160)),
        ((100, 50), (100, 50)),
        ((3000, 4), (160, 1)),
    ],
)
def test_thumbnails_keep_the_shape_and_never_grow(tmp_path, size, expected):
    path = tmp_path / "frame.jpg"
    path.write_bytes(_encode(".jpg", _plain(*size)))
    thumbnail = decode_thumbnail(path, max_side=160)
    assert (thumbnail.shape[1], thumbnail.shape[0]) == expected
    np.testing.assert_allclose(thumbnail[0, 0], [*COLOUR, 255], atol=4)


def test_what_other_programs_append_to_a_picture_is_left_alone(tmp_path):
    path = tmp_path / "longer.png"
    path.write_bytes(_encode(".png", _plain(8, 6)) + b"\xff" * 50)
    assert decode_bgra(path).shape == (6, 8, 4)


@pytest.mark.parametrize("decode", [decode_bgra, decode_thumbnail, read_size])
@pytest.mark.parametrize(
    ("data", "problem"),
    [
        (b"", "empty"),
        (b"not a picture at all", "cannot be decoded"),
        (b"\x89PNG\r\n\x1a\n" + b"\x00" * 40, "cannot be decoded"),
        (b"\xff\xd8\xff\xe0", "cannot be decoded"),
        (_encode(".png", _plain(8, 6))[:33] + b"\x7f\xff\xff\xffIDAT", "a part of the file"),
        (_encode(".png", _plain(80, 60))[:-30], "a part of the file"),
    ],
)
def test_a_damaged_picture_is_one_line_that_names_it(tmp_path, decode, data, problem):
    path = tmp_path / "broken.jpg"
    path.write_bytes(data)
    assert callable(decode)
    with pytest.raises(ImageError, match=problem) as caught:
        decode(path)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_folder_a_missing_file_and_a_pipe_are_errors(tmp_path):
    folder = tmp_path / "folder.jpg"
    folder.mkdir()
    with pytest.raises(ImageError, match="is a folder"):
        decode_bgra(folder)
    with pytest.raises(ImageError, match="No such file"):
        decode_bgra(tmp_path / "gone.png")
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe.png")
        with pytest.raises(ImageError, match="is a pipe, a socket"):
            decode_bgra(tmp_path / "pipe.png")


def _png_of(width: int, height: int) -> bytes:
    """A valid PNG of plain black, a thousandth of the size of its pixels."""
    packer = zlib.compressobj(1)
    row = bytes(1 + (width + 7) // 8)
    body = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
    chunks = [
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 1, 0, 0, 0, 0)),
        (b"IDAT", body),
        (b"IEND", b""),
    ]
    parts = [
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


@pytest.mark.parametrize("decode", [decode_bgra, decode_thumbnail, read_size])
def test_a_picture_too_large_for_memory_is_refused_before_it_is_unpacked(
    tmp_path, decode, monkeypatch
):
    path = tmp_path / "bomb.png"
    path.write_bytes(_png_of(30000, 30000))
    monkeypatch.setattr(cv2, "imdecode", lambda *_: pytest.fail("it was decoded"))
    assert callable(decode)
    with pytest.raises(ImageError, match="30000 x 30000 px, expected at most 100 megapixels"):
        decode(path)


def test_a_hundred_megapixels_are_the_limit(tmp_path):
    path = tmp_path / "wide.png"
    path.write_bytes(_png_of(1_000_000, 100))
    assert read_size(path) == (1_000_000, 100)
    path.write_bytes(_png_of(1_000_000, 101))
    with pytest.raises(ImageError, match="1000000 x 101 px"):
        read_size(path)


@pytest.mark.parametrize("flags", [[], [cv2.IMWRITE_JPEG_PROGRESSIVE, 1]])
def test_the_header_of_a_jpeg_says_its_size(flags):
    done, data = cv2.imencode(".jpg", _plain(333, 222), flags)
    assert done
    assert header_size(data.tobytes()) == (333, 222)
    assert header_size(_exif_jpeg(_plain(64, 32), orientation=6)) == (64, 32)


@pytest.mark.parametrize("quality", [50, 101])  # webp above 100 is without loss
def test_the_headers_of_the_other_kinds_say_their_size(quality):
    for suffix in (".png", ".bmp"):
        assert header_size(_encode(suffix, _plain(333, 222))) == (333, 222)
    done, data = cv2.imencode(".webp", _plain(333, 222), [cv2.IMWRITE_WEBP_QUALITY, quality])
    assert done
    assert header_size(data.tobytes()) == (333, 222)
    extended = b"VP8X" + struct.pack("<I", 10) + bytes(4)
    extended += (332).to_bytes(3, "little") + (221).to_bytes(3, "little")
    assert header_size(b"RIFF" + bytes(4) + b"WEBP" + extended) == (333, 222)
    top_down = _encode(".bmp", _plain(8, 6))
    top_down = top_down[:22] + struct.pack("<i", -6) + top_down[26:]
    assert header_size(top_down) == (8, 6)


def test_no_header_that_was_cut_off_is_more_than_an_unknown_size():
    for suffix in PICTURE_SUFFIXES - {".tif", ".jpeg", ".pgm"}:
        data = _encode(suffix, _plain(64, 36))
        for length in range(0, len(data), 1 + len(data) // 300):
            assert header_size(data[:length]) in (None, (64, 36))


def test_a_picture_of_another_kind_is_refused_whatever_its_name(tmp_path):
    path = tmp_path / "renamed.png"
    path.write_bytes(_encode(".hdr", _plain(40, 30).astype(np.float32)))
    with pytest.raises(ImageError, match="not jpg, png, bmp, webp"):
        decode_bgra(path)


def test_an_animation_is_no_picture(tmp_path):
    path, animation = tmp_path / "moving.gif", cv2.Animation()
    animation.frames, animation.durations = [_plain(40, 30)] * 3, [100] * 3
    assert cv2.imwriteanimation(str(path), animation)
    with pytest.raises(ImageError, match=r"animation of 3 pictures.*ffmpeg"):
        decode_bgra(path)


def test_a_file_of_several_pictures_is_no_picture(tmp_path):
    path = tmp_path / "pages.tiff"
    assert cv2.imwritemulti(str(path), [_plain(40, 30)] * 3)
    with pytest.raises(ImageError, match="holds 3 pictures, expected one"):
        decode_bgra(path)
    gif = _encode(".gif", _plain(40, 30))
    start = gif.index(b"\x2c\0\0\0\0")  # the image, without what controls it in an animation
    path.with_suffix(".gif").write_bytes(gif[:-1] + gif[start:])
    with pytest.raises(ImageError, match="animation of 2 pictures"):
        decode_bgra(path.with_suffix(".gif"))


def test_a_thumbnail_of_a_picture_one_pixel_wide(tmp_path):
    path = tmp_path / "thin.png"
    path.write_bytes(_encode(".png", _plain(1, 3000)))
    assert decode_thumbnail(path).shape == (160, 1, 4)
