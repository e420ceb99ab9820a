"""The filter's language: what each condition finds, what typing may leave open, what is refused."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from procc_annotator.dataset import filter_query
from procc_annotator.dataset.filter_query import (
    QUERY_HELP,
    STATUSES,
    FrameFacts,
    FrameQuery,
    parse_query,
)
from procc_annotator.dataset.frames import folders_of, rows_of
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field

FIELD = load_field("soccer")


def _no_score(tau: float | None) -> float | None:
    return None


def _scores(in_use: float, at_5: float) -> Callable[[float | None], float | None]:
    return {None: in_use, 5.0: at_5}.get


PLAIN = FrameFacts("Match_1_frame_07", "untouched", (), 0, 0, "", False, False, False, _no_score)
DRAWN = replace(
    PLAIN,
    name="match_2_frame_08",
    status="in progress",
    annotated=("Circle left", "Goal left post left ", "Corner flag"),
    comments=2,
    open_comments=1,
    comment_text="The far post is BLURRED",
    unsaved=True,
    unconfirmed=True,
    jac=_scores(2 / 3, 0.8),
)
BROKEN = replace(PLAIN, name="odd, name: 3", status="rejected", annotated=None, unreadable=True)
FRAMES = {"plain": PLAIN, "drawn": DRAWN, "broken": BROKEN}


def _found(text: str) -> set[str]:
    query = parse_query(text, FIELD)
    assert query.incomplete == ""
    return {key for key, facts in FRAMES.items() if query.matches(facts)}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "plain drawn broken"),
        ("match", "plain drawn"),
        ("MATCH frame_07", "plain"),
        ("-match", "broken"),
        ("mat*_08", "drawn"),
        ('"odd, name: 3"', "broken"),
        ('"2_FRAME"', "drawn"),
        ("name:odd,", "broken"),
        ("12:30", ""),
        ("state:rejected", "broken"),
        ("status:REJECTED,untouched", "plain broken"),
        ('state:"in progress"', "drawn"),
        ("state:in_progress,done", "drawn"),
        ("-state:rejected", "plain drawn"),
        ('has:"circle LEFT"', "drawn"),
        ('has:"Left penalty arc"', "drawn"),  # its title
        ('has:"Goal left post left"', "drawn"),  # without the trailing space of files
        ("has:Circle*", "drawn"),
        ("has:*crossbar", ""),
        ("has:corner*", "drawn"),  # a class the field does not know
        ('has:"Middle line",circ*', "drawn"),
        ("has:*", "drawn"),
        ("-has:*", "plain"),  # of the broken one nothing can be said
        ("n:0", "plain"),
        ("elements:>=3", "drawn"),
        ("n:1..3", "drawn"),
        ("n:..3", "plain drawn"),
        ("-n:3", "plain"),
        ("comments:>0", "drawn"),
        ("comments:open", "drawn"),
        ("comments:none", "plain broken"),
        ("comment:blurred", "drawn"),
        ('comment:"far post"', "drawn"),
        ("is:unsaved", "drawn"),
        ("is:unreadable", "broken"),
        ("is:unconfirmed,unreadable", "drawn broken"),
        ("-is:unconfirmed", "plain broken"),
        ("jac:<0.8", "drawn"),
        ("jac5:<0.8", ""),
        ("jac5:<=.8", "drawn"),
        ("jac@5.0:0.2..0.8", "drawn"),
        ("jac:=0.67", "drawn"),  # as it is shown
        ("jac:0.667", "drawn"),
        ("jac:0.668", ""),
        ("jac2.5:>=0", ""),  # no score at this tau
        ("-jac5:<0.8", "drawn"),  # frames without a score answer neither way
        ("jac:none", "plain broken"),
        ("state:in_progress,rejected is:unsaved 08", "drawn"),
        ('-"match_1" -state:rejected', "drawn"),
        ("“frame_07”", "plain"),
    ],
)
def test_what_a_filter_finds(text, expected):
    assert _found(text) == set(expected.split())


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("state:", "character 7: a status is missing: untouched"),
        ("state:rej", "'rej' is not finished: rejected"),
        ("is:un", "unsaved, unreadable, unconfirmed"),
        ("has:Circle", '"Circle central", "Circle left", "Circle right"'),
        ('has:"Circle le', "character 1: the closing quote is missing"),
        ("jac5:", "character 6: a number is missing, as in <0.8"),
        ("jac5:<", "a number is missing"),
        ("jac5:<0.", "a number is missing"),
        ("jac:0.2..", "the range that begins with 0.2 is missing"),
        ("jac:0.8..0", "ends before it begins"),
        ("n:>=", "a number is missing, as in <5"),
        ("n:3..1", "ends before it begins"),
        ("comments:op", "not finished: open"),
        ("comment:", "a part of a comment is missing"),
        ("name:", "a part of a name is missing"),
        ("-", "a part of a name is missing"),
        ('""', "a part of a name is missing"),
    ],
)
def test_what_is_not_finished_lets_all_frames_through(text, says):
    for written in (text, "-" + text.removeprefix("-")):
        query = parse_query(written, FIELD)
        assert query.is_empty
        assert all(query.matches(facts) for facts in FRAMES.values())
    assert says in parse_query(text, FIELD).incomplete


def test_finished_conditions_count_beside_unfinished_ones():
    query = parse_query("state:untouched jac5:<", FIELD)
    assert query.incomplete.startswith("character 22:")
    assert [query.matches(f) for f in FRAMES.values()] == [True, False, False]
    # of alternatives too
    query = parse_query("state:untouched,rej", FIELD)
    assert "'rej' is not finished" in query.incomplete
    assert [query.matches(f) for f in FRAMES.values()] == [True, False, False]


@pytest.mark.parametrize("whole", [word for word, _ in QUERY_HELP] + ["jac5:0.2..0.8", "n:3..12"])
def test_typing_a_filter_is_no_error_at_any_moment(whole):
    assert parse_query(whole, FIELD).incomplete == ""
    key, colon, value = whole.partition(":")
    for typed in range(len(value) + 1):
        parse_query(f"{key}{colon}{value[:typed]}", FIELD)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("stat:done", r"unknown filter 'stat:'; did you mean 'state:'\?; put it in quotes"),
        ("x frame:3", r"character 3: unknown filter 'frame:'.*in quotes"),
        ("state:rejectd", r"character 7: 'rejectd' is not a status; did you mean rejected\?"),
        ("state:done,aproved", r"character 12: .* did you mean approved\?"),
        ("state:blue", r"choose one of untouched, in progress, done, approved, rejected"),
        ("state:unsaved", r"did you mean is:unsaved\?"),
        ("is:in_progress", r'did you mean state:"in progress"\?'),
        ("is:unsavd", r"did you mean unsaved\?"),
        ('has:"Circle lefd"', r'did you mean "Circle left"\?'),
        ('has:"Left penalti arc"', r'did you mean "Left penalty arc"\?'),
        ("has:flag", r"not a class of this field; with a \*"),
        ("has:comment", r"did you mean comments:>0\?"),
        ("jac:<80", r"character 5: JaC runs from 0 to 1, not to '80' \(80 % is 0.8\)"),
        ("jac:<0,8", r"decimals with a point: 0.8"),
        ("jac:0.8..0.2", r"character 5: the range 0.8..0.2 ends before it begins; turn it around"),
        ("jac:nan", r"'nan' is not a number; write it as in <0.8"),
        ("jac0:<0.5", r"tau is a distance above 0 px, not '0'"),
        ("n:<5.5", r"'5.5' is not a whole number"),
        ("n:-1", r"'-1' is not a number"),
        ("comments:often", r"'often' is not a number; .*open"),
    ],
)
def test_what_is_refused(text, message):
    with pytest.raises(UsageError, match=message) as caught:
        parse_query(text, FIELD)
    assert str(caught.value).startswith("filter, character ")


def test_what_a_filter_needs_and_that_costly_conditions_come_last():
    def needs(text: str) -> tuple[bool, bool]:
        query = parse_query(text, FIELD)
        return query.needs_annotation, any(c.needs == filter_query._JAC for c in query._conditions)

    assert needs("frame state:done comments:open is:unsaved") == (False, False)
    assert needs("has:* is:unsaved") == (True, False)
    assert needs("n:<5") == (True, False)
    assert needs("is:unreadable") == (True, False)
    assert needs("jac5:>0 n:>3") == (True, True)
    assert needs("jac5:< n:") == (False, False)

    asked = []

    def jac(tau: float | None) -> float | None:
        asked.append(tau)
        return 0.5

    query = parse_query("jac5:<0.8 jac:<0.6 state:done", FIELD)
    assert not query.matches(replace(PLAIN, jac=jac))
    assert asked == []
    assert query.matches(replace(PLAIN, jac=jac, status="done"))
    assert asked == [5.0, None]


def test_statuses_with_underscores_are_found_too():
    assert parse_query('state:"In Progress"', FIELD).matches(replace(PLAIN, status="in_progress"))
    for status in STATUSES:
        assert parse_query(f'state:"{status}"', FIELD).matches(replace(PLAIN, status=status))


def test_queries_are_values():
    assert parse_query("n:<5", FIELD) == parse_query("n:<5", FIELD)
    assert parse_query("n:<5", FIELD) != parse_query("n:<6", FIELD)
    assert repr(parse_query("n:<5", FIELD)) == "FrameQuery(text='n:<5', incomplete='')"


def test_many_stars_are_no_trap():
    facts = replace(PLAIN, name="a" * 200)
    assert not parse_query("*a" * 30 + "*b", FIELD).matches(facts)
    assert parse_query("*a" * 30 + "*", FIELD).matches(facts)


_WORDS = st.sampled_from(
    ["state:", "jac", "jac5:", "has:", "n:", "is:", "comments:", '"', "-", ",", "..", "<", ">=",
     "0.8", "9", "*", " ", "Circle left", "done", "un", ":", "=", "."]
)  # fmt: skip


@given(st.one_of(st.text(), st.lists(_WORDS).map("".join)))
@example("jac" + "9" * 400 + ":<1")
@example("n:" + "9" * 5000)
@example("\u2028:\n\0")
def test_any_text_is_a_filter_or_one_line_of_advice(text):
    try:
        query = parse_query(text, FIELD)
    except UsageError as error:
        said = str(error)
        assert said.startswith("filter, character ")
    else:
        assert isinstance(query, FrameQuery)
        assert query.text == text
        said = query.incomplete
        for facts in FRAMES.values():
            assert isinstance(query.matches(facts), bool)
    assert len(said.splitlines()) <= 1


@given(st.text(min_size=1).filter(lambda s: not set(s) & set('"“”„*')))
def test_a_quoted_name_finds_its_frame(name):
    facts = replace(PLAIN, name=f"a{name}b")
    assert parse_query(f'"{name}"', FIELD).matches(facts)
    assert not parse_query(f'-"{name}"', FIELD).matches(facts)


@given(st.integers(0, 40), st.integers(0, 40))
def test_a_condition_and_its_opposite_part_the_frames(limit, count):
    facts = replace(PLAIN, annotated=tuple(str(i) for i in range(count)))
    less = parse_query(f"n:<{limit}", FIELD).matches(facts)
    assert less is (count < limit)
    assert parse_query(f"-n:<{limit}", FIELD).matches(facts) is not less
    assert parse_query(f"n:>={limit}", FIELD).matches(facts) is not less


# The folders of a tree as rows of a list.

NAMES = [
    *("epl/a/img1/1", "epl/a/img1/2", "epl/b/img1/1"),
    *("liga/x/1", "liga/x/deep/1", "liga/x/deep/2"),
]


def test_a_folder_that_holds_nothing_but_another_is_one_with_it():
    folders = folders_of(NAMES)
    assert [(f.label, f.depth) for f in folders] == [
        ("epl", 0),
        ("a/img1", 1),
        ("b/img1", 1),
        ("liga/x", 0),
        ("deep", 1),
    ]
    assert [(f.first, f.own_past, f.past) for f in folders] == [
        (0, 0, 3),
        (0, 2, 2),
        (2, 3, 3),
        (3, 4, 6),
        (4, 6, 6),
    ]


def test_a_flat_dataset_has_no_folders():
    assert folders_of(["1", "2"]) == ()
    assert folders_of([]) == ()


def test_rows_are_folders_and_the_frames_in_those_that_are_open():
    folders = folders_of(NAMES)
    assert rows_of(folders, (), None) == [-1, -2, 0, 1, -3, 2, -4, 3, -5, 4, 5]
    assert rows_of(folders, {"epl"}, None) == [-1, -4, 3, -5, 4, 5]
    assert rows_of(folders, {"epl/a/img1", "liga/x"}, None) == [-1, -2, -3, 2, -4]


def test_folders_without_a_frame_that_is_shown_are_left_out():
    folders = folders_of(NAMES)
    assert rows_of(folders, (), [1, 5]) == [-1, -2, 1, -4, -5, 5]
    assert rows_of(folders, {"liga/x/deep"}, [1, 5]) == [-1, -2, 1, -4, -5]
    assert rows_of(folders, (), []) == []
