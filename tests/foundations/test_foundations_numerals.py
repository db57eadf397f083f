"""Numbers as a reader sees them."""

from __future__ import annotations

import ast
import re

import pytest

from compwright.foundations.numerals import significant
from source_trees import nodes_below, trees

#: Rooms that speak of what was measured, estimated, fitted and predicted.
SPEAKING = ("estimation", "evaluation", "fitting", "planning", "verification")
#: Certificates are as small as arithmetic makes them: there an exponent is what one reads.
CERTIFICATES = ("certify", "mean_range", "solve")


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (0.000123, 2, "0.00012"),
        (-0.05, 2, "-0.05"),
        (5.43, 2, "5.4"),
        (99.6, 2, "100"),
        (-153.2, 2, "-150"),
        (1.5e6, 2, "1500000"),
        (0.0, 2, "0"),
        (1234.5, 3, "1230"),
    ],
)
def test_no_exponents(value: float, digits: int, text: str) -> None:
    assert significant(value, digits) == text


def test_no_sentence_takes_two_or_three_digits_in_a_way_that_writes_exponents() -> None:
    """``.2g`` and ``.3g`` write 150 µm as 1.5e+02 and 1500 as 1.5e+03."""
    found = [
        f"{module}: {ast.unparse(node)}"
        for module, tree in trees().items()
        if module.partition(".")[0] in SPEAKING and module.rpartition(".")[2] not in CERTIFICATES
        for node in nodes_below(tree)
        if isinstance(node, ast.FormattedValue)
        and node.format_spec is not None
        and re.search(r"\.[23]g", ast.unparse(node.format_spec))
    ]
    assert found == []
