"""What people call a camera's model: pinholes are told apart by what is free in them."""

from __future__ import annotations

from procc_annotator.camera.pinhole import PinholeCamera

# Half a pixel is what conventions of a picture's centre differ by.
_CENTRED_TOLERANCE_PX = 1.0
# Sizes whose shapes are not quite the same stretch pixels by less.
_SQUARE_PIXEL_TOLERANCE = 2e-3


def model_name(camera: object, family: str, size: tuple[int, int]) -> str:
    """``pinhole P``, ``R``, ``R+`` or ``R2``, as fits are named; ``pinhole full`` with other
    coefficients than k1 and k2. Of any other model what its file or plug-in calls it.

    P has one focal length and its principal point in the centre, R k1 besides, R+ an aspect ratio
    and a principal point of its own, R2 a second coefficient.

    Args:
        camera: in px of ``size``. family: what its file or plug-in calls it.
        size: (width, height) px.
    """
    if not isinstance(camera, PinholeCamera):
        return family
    k1, k2, *others = camera.radial
    if any(others) or any(camera.tangential) or any(camera.thin_prism):
        return f"{family} full"
    if k2:
        return f"{family} R2"
    ratio = camera.focal_px[1] / camera.focal_px[0]
    off = [
        abs(at - (length - 1) / 2)
        for at, length in zip(camera.principal_point_px, size, strict=True)
    ]
    if abs(ratio - 1) > _SQUARE_PIXEL_TOLERANCE or max(off) > _CENTRED_TOLERANCE_PX:
        return f"{family} R+"
    return f"{family} R" if k1 else f"{family} P"
