"""The sports of the sample, by the names of their fields."""

from __future__ import annotations

from drawing.soccer import SOCCER
from drawing.sport import Sport

SPORTS: dict[str, Sport] = {sport.field_name: sport for sport in (SOCCER,)}
