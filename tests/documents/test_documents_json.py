"""Documents as JSON text: the bytes that the standard library's own indented form has."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from compwright.documents.json_text import to_json

NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
LEAVES = st.none() | st.booleans() | st.integers() | NUMBERS | st.text(max_size=8)
VALUES: st.SearchStrategy[Any] = st.recursive(
    LEAVES | st.lists(NUMBERS | st.none()),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.lists(inner, max_size=3).map(tuple)
        | st.dictionaries(st.text(max_size=4), inner, max_size=4)
    ),
    max_leaves=12,
)


#: Delete and the C1 control characters, the marks that turn the direction of writing or take no
#: room, and the line and paragraph separators (Unicode 15, UAX 9): JSON allows them as they are.
TERMINAL_OBEYS = (
    *(*range(0x7F, 0xA0), 0xAD, 0x61C, 0x180E, *range(0x200B, 0x2010)),
    *(*range(0x2028, 0x202F), *range(0x2060, 0x2070), 0xFEFF, *range(0xFFF9, 0xFFFC)),
)


def without_minus_zero(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: without_minus_zero(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [without_minus_zero(one) for one in value]
    return 0.0 if isinstance(value, float) and value == 0 else value


def test_no_document_holds_a_minus_zero() -> None:
    document = {
        "a": -0.0,
        "b": [-0.0, 1.0, None],
        "c": [[-0.0], "-0.0"],
        "d": {"e": np.float64(-0.0)},
    }
    zeros = {"a": 0.0, "b": [0.0, 1.0, None], "c": [[0.0], "-0.0"], "d": {"e": 0.0}}
    assert to_json(document) == json.dumps(zeros, indent=2) + "\n"


@given(st.dictionaries(st.text(max_size=4), VALUES, max_size=4))
def test_it_is_what_the_standard_library_writes(document: dict[str, Any]) -> None:
    written = json.dumps(without_minus_zero(document), ensure_ascii=False, indent=2) + "\n"
    for code in TERMINAL_OBEYS:
        written = written.replace(chr(code), f"\\u{code:04x}")
    assert to_json(document) == written
    assert json.loads(to_json(document)) == json.loads(json.dumps(document))


def test_words_with_commas_and_numbers_of_numpy() -> None:
    document = {"a, b": ["x, y", 1.5], "c": [np.float64(0.1), 2.0, None], "d": [1, 2.5, 0.0]}
    assert to_json(document) == json.dumps(document, indent=2) + "\n"


@pytest.mark.parametrize("value", [math.nan, math.inf, [1.0, math.nan], {"a": [-math.inf]}, b"x"])
def test_what_json_cannot_hold_is_refused(value: Any) -> None:
    with pytest.raises((ValueError, TypeError)):
        to_json({"value": value})


def test_half_a_character_of_a_file_name_stands_as_its_escape() -> None:
    assert to_json({"file": "a\udcff.csv"}) == '{\n  "file": "a\\udcff.csv"\n}\n'
