"""The setup: what it accepts and how it names itself."""

from __future__ import annotations

import pickle

import pytest

from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.metrics.setup import EvaluationSetup


def test_it_says_what_was_evaluated(soccer):
    assert EvaluationSetup(soccer).describe() == "soccernet, 960x540"
    other = EvaluationSetup(load_field("volleyball"), protocol="procc")
    assert other.describe() == "procc, 960x540, volleyball"
    left_out = EvaluationSetup(soccer, (1280, 720), off_plane="left_out")
    assert left_out.describe() == "soccernet, 1280x720"
    assert left_out.describe(ground_only=True) == "soccernet, 1280x720, off-plane elements left out"
    missed = EvaluationSetup(soccer).describe(ground_only=True)
    assert missed == "soccernet, 960x540, off-plane elements counted as missed"
    lenient = EvaluationSetup(soccer, protocol="procc", allow_mirrored=True)
    assert lenient.describe() == "procc, 960x540, mirrored labels allowed"


def test_a_misspelt_protocol_is_refused_with_a_hint(soccer):
    with pytest.raises(UsageError, match=r"'soccer-net'; did you mean 'soccernet'\?"):
        EvaluationSetup(soccer, protocol="soccer-net")
    with pytest.raises(UsageError, match="choose one of missed, left_out"):
        EvaluationSetup(soccer, off_plane="?")
    with pytest.raises(UsageError, match="1x540"):
        EvaluationSetup(soccer, size=(1, 540))


def test_it_travels_to_a_worker_process(soccer):
    setup = EvaluationSetup(soccer, protocol="procc")
    assert len(setup.tables.names) == len(soccer.elements)
    copy = pickle.loads(pickle.dumps(setup))  # noqa: S301
    assert copy == setup
    assert copy.tables.names == setup.tables.names
