"""The one patcher: what is said changes, every other byte stays. Expected bytes written by hand."""

from __future__ import annotations

import pytest

from compwright.formats.definition.schema import Definition
from compwright.formats.text.patching import BytesChange, Patches
from compwright.formats.text.texts import text_reader
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS, SIEMENS

FANUC = DEFINITIONS["fanuc-30i"]


def patches(content: bytes, definition: Definition = SIEMENS) -> Patches:

    return Patches(
        definition.dialect, [ControlFile("other", b"kept"), ControlFile("a.ini", content)]
    )


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"a\nb\n", b"a\nnew\nb\n"),
        (b"a\r\nb\r\n", b"a\r\nnew\r\nb\r\n"),  # each line has the end of its neighbour
        (b"a", b"a\nnew"),  # a last line without an end gets one, the new last line none
        (b"a\x1a", b"a\nnew\x1a"),  # the end mark of old systems stays at the end
    ],
)
def test_a_line_put_behind_another_has_its_end(content: bytes, expected: bytes) -> None:
    changes = patches(content)
    changes.add_lines(1, 0, ["new"])
    assert changes.patched(changes.changed()) == (ControlFile("a.ini", expected),)


def test_lines_behind_one_line_keep_their_order_and_stand_behind_those_before_the_next() -> None:
    changes = patches(b"a\nb\n")
    changes.add_lines(1, 0, ["1", "2"])
    changes.add_lines(1, 2, ["3"], before=True)
    assert changes.patched([1])[0].content == b"a\n1\n2\n3\nb\n"


def test_several_lines_behind_a_last_line_without_an_end_are_lines_of_their_own() -> None:
    changes = patches(b"a\nb")
    changes.add_lines(1, 2, ["1", "2"])
    assert changes.patched([1])[0].content == b"a\nb\n1\n2"


def test_a_bare_carriage_return_ends_no_line_where_the_control_knows_none() -> None:
    changes = patches(b"a\rb\nc\n")
    changes.cut_line(1, 2)
    assert changes.patched([1])[0].content == b"c\n"


def test_line_feed_and_two_carriage_returns_are_one_line_end() -> None:
    # LF CR CR: how the control ends a block where its punch code says so.
    changes = patches(b"N1\n\r\rN2\n\r\r", FANUC)
    changes.add_lines(1, 6, ["N15"], before=True)
    assert changes.patched([1])[0].content == b"N1\n\r\rN15\n\r\rN2\n\r\r"


def test_what_is_replaced_twice_counts_by_its_last_text() -> None:
    changes = patches(b"mask=01;\n")
    changes.replace(1, BytesChange(5, 7, b"11"))
    changes.replace(1, BytesChange(5, 7, b"10"))
    assert changes.patched([1])[0].content == b"mask=10;\n"


def test_a_field_says_what_was_put_into_it_last() -> None:
    content = b"N1 $MA_BACKLASH[0,AX1]=0.5 ; kept\n"
    changes = patches(content)
    read = text_reader(SIEMENS).read(changes.files[1], [])
    assert read is not None
    token = read.occurrences[0].tokens["value"]
    assert changes.text(1, token) == "0.5"
    changes.replace(1, BytesChange(token.start, token.end, b"-1.25"))
    assert changes.text(1, token) == "-1.25"
    assert changes.like(1, read.occurrences[0], {"value": "7"}) == (
        "N1 $MA_BACKLASH[0,AX1]=7 ; kept"
    )


def test_only_files_that_change_are_said_to_change() -> None:
    changes = patches(b"a\n")
    assert changes.changed() == set()
    assert changes.patched([1, 0]) == (
        ControlFile("other", b"kept"),
        ControlFile("a.ini", b"a\n"),
    )
