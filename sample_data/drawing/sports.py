"""The sports of the sample, by the names of their fields."""

from __future__ import annotations

from drawing.basketball import BASKETBALL
from drawing.ice_hockey import ICE_HOCKEY
from drawing.soccer import SOCCER
from drawing.sport import Sport
from drawing.volleyball import VOLLEYBALL

SPORTS: dict[str, Sport] = {
    sport.field_name: sport for sport in (SOCCER, BASKETBALL, VOLLEYBALL, ICE_HOCKEY)
}
