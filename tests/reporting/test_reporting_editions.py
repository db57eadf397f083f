"""Terms of the editions against the printed ones: ISO 230-2:1988 clause 6 and table 2, ISO 230-2:1997
clause 7.2, ISO 230-2:2006 clause 2.
"""

from __future__ import annotations

import pytest

from compwright.reporting.edition_terms import edition_symbol, parameter_term


@pytest.mark.parametrize(
    ("edition", "parameter", "symbol", "printed"),
    [
        ("iso230-2:1988", "B_mean", "mean B", "Mean reversal error"),
        ("iso230-2:1988", "R_positive", "R↑", "Unidirectional repeatability of positioning"),
        ("iso230-2:1988", "A", "A", "Accuracy"),
        ("iso230-2:1997", "A_positive", "A↑", "Unidirectional accuracy of positioning"),
        ("iso230-2:1997", "A", "A", "Bidirectional accuracy of positioning"),
        ("iso230-2:1997", "E_negative", "E↓", "Unidirectional systematic positional deviation"),
        ("iso230-2:1997", "M", "M", "Mean bidirectional positional deviation"),
        ("iso230-2:1997", "B", "B", "Reversal value"),
        ("iso230-2:1997", "B_mean", "mean B", "Mean reversal value"),
        ("iso230-2:2006", "E", "E", "Bi-directional systematic positional deviation"),
        ("iso230-2:2006", "M", "M", "Mean bi-directional positional deviation"),
        ("iso230-2:2006", "R_negative", "R↓", "Unidirectional repeatability of positioning"),
    ],
)
def test_each_edition_has_its_own_words(
    edition: str, parameter: str, symbol: str, printed: str
) -> None:
    assert edition_symbol(parameter, edition) == symbol
    assert str(parameter_term(parameter, edition)) == printed


def test_without_a_text_of_the_edition_directions_are_signs() -> None:
    assert edition_symbol("A_positive", "iso230-2:2014") == "A+"
