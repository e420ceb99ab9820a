"""The probability that a camera found in a picture is right, and what speaks most against it."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.resources import resources_dir
from procc_annotator.translation import translatable

SURE_FROM = 0.99
"""The probability from which on a camera is called sure."""
POSSIBLE_FROM = 0.5
"""Below, a camera is more likely wrong than right, and is not proposed."""
MODEL_FILE = "proposal_probability.toml"

_HALF_SHARE = 0.02  # shares of 0 and 1 have finite odds
# Beyond these, evidence says nothing more about other matches (cross-validated): a clear margin, or
# no rival at all; a quarter of the starts; projected lines known to a pixel.
_MAX_MARGIN, _MAX_SUPPORT, _MIN_SD_PX = 0.2, 0.25, 1.0


@dataclass(frozen=True)
class ProposalEvidence:
    """Evidence for and against a camera.

    Attributes:
        coverage: share of the lines in sight that were found on line pixels, 0 to 1.
        explained: share of the line pixels on the field that are on its lines, 0 to 1.
        margin: how much better it is than the best plausible camera that shows something else.
        length_px: length of the lines that were found, solver px.
        elements: number of elements of which most was found.
        support: share of the search's last starts that ended at it.
        unlikeliness: half the squared deviations from where cameras are expected.
        sd_px: standard deviation of projected line points, 90 % quantile, solver px.
        displaced: elements that are next to their line pixels, in words; "" for none.
    """

    coverage: float
    explained: float
    margin: float
    length_px: float
    elements: int
    support: float
    unlikeliness: float
    sd_px: float
    displaced: str = ""

    @property
    def features(self) -> FloatArray:
        """(9,) in the order of `FEATURES`; each grows with what speaks for the camera."""
        return np.array(
            [
                _log_odds(self.coverage),
                _log_odds(self.explained),
                min(self.margin, _MAX_MARGIN),
                math.log(max(self.length_px, 1.0)),
                math.log1p(self.elements),
                min(self.support, _MAX_SUPPORT),
                -math.sqrt(self.unlikeliness),
                -math.log(max(self.sd_px, _MIN_SD_PX)),
                -float(bool(self.displaced)),
            ]
        )


FEATURES = (
    "coverage", "explained", "margin", "length", "elements", "support", "placement", "determined",
    "displaced",
)  # fmt: skip


def _log_odds(share: float) -> float:
    return math.log((share + _HALF_SHARE) / (1 - share + _HALF_SHARE))


@dataclass(frozen=True, eq=False)
class LogisticModel:
    """Log odds that a camera is right: a constant and a weight for each feature.

    Attributes:
        intercept: log odds of a camera with the typical features.
        typical: (9,) mean features of right cameras.
        weights: (9,) per unit of a feature, none negative.
    """

    intercept: float
    typical: FloatArray
    weights: FloatArray

    def probability(self, features: FloatArray) -> FloatArray:
        """(..., 9) features -> (...) probability that the camera is right."""
        odds = self.intercept + (features - self.typical) @ self.weights
        return np.asarray(0.5 * (1 + np.tanh(odds / 2)))

    def losses(self, features: FloatArray) -> FloatArray:
        """(9,) log odds that each feature (9,) costs against a typical right camera."""
        return np.asarray((self.typical - features) * self.weights)


@cache
def logistic_model() -> LogisticModel:
    """The fitted model; how it was made stands in its file."""
    with (resources_dir() / MODEL_FILE).open("rb") as file:
        table = tomllib.load(file)
    rows: Mapping[str, Mapping[str, float]] = table["features"]
    typical, weights = (
        np.array([rows[name][key] for name in FEATURES]) for key in ("typical", "weight")
    )
    return LogisticModel(float(table["intercept"]), typical, weights)


def probability_right(evidence: ProposalEvidence) -> float:
    """Return the probability that a camera is right, 0 to 1."""
    return float(logistic_model().probability(evidence.features))


def main_doubt(evidence: ProposalEvidence) -> str:
    """What lowers the probability most, in words."""
    texts = {
        "coverage": translatable("expected lines are missing"),
        "explained": translatable("some lines in the picture do not match the field"),
        "margin": rival_camera_reason(),
        "length": translatable("too few lines in view"),
        "elements": translatable("too few lines in view"),
        "support": rival_camera_reason(),
        "placement": translatable("unusual camera position"),
        "determined": translatable("the visible lines do not determine the camera"),
        "displaced": evidence.displaced,
    }
    return texts[FEATURES[int(logistic_model().losses(evidence.features).argmax())]]


def rival_camera_reason() -> str:
    """The reason for a camera that is not sure because of another one."""
    return translatable("a different view fits almost as well")
