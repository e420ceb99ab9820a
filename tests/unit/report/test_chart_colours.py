"""Lines of charts are seen on the light page and on the dark one."""

import pytest

from procc_annotator.field.model import linear_rgb
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.report.page.chart_style import readable_on_both_themes

PAGES = ("#ffffff", "#16181b")  # --paper of report.css, light and dark


def luminance(colour: str) -> float:
    return float(linear_rgb(colour) @ (0.2126, 0.7152, 0.0722))


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("colour", [*SOURCE_COLOURS, "#000000", "#ffffff", "#16181b"])
def test_every_line_stands_out_from_the_page(colour, page):
    dark, light = sorted((luminance(readable_on_both_themes(colour)), luminance(page)))
    assert (light + 0.05) / (dark + 0.05) >= 3.0


def test_a_colour_that_is_seen_already_stays():
    assert readable_on_both_themes("#4a8dff") == "#4a8dff"
