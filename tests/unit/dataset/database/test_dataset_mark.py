"""What is remembered of one dataset is not told of another at the same path."""

from __future__ import annotations

from procc_annotator.dataset.database.location import (
    fingerprint_of,
    fingerprints_match,
    matches_folder,
)


def test_videos_tell_datasets_apart(tmp_path) -> None:
    for match, content in (("a", b"one half"), ("b", b"another half")):
        (tmp_path / match).mkdir()
        (tmp_path / match / f"{match}.mp4").write_bytes(content)
    a, b = tmp_path / "a", tmp_path / "b"
    assert matches_folder(fingerprint_of(a), a)
    assert not matches_folder(fingerprint_of(a), b)
    assert not fingerprints_match(fingerprint_of(a), fingerprint_of(b))
