"""Cameras from annotated elements: fit a model, robustly and with its uncertainty."""

from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.models import MODELS
from procc_annotator.fit.result import ElementResidual, FitResult, PoseDeviations

__all__ = ["MODELS", "ElementResidual", "FitResult", "PoseDeviations", "fit_camera"]
