"""Terms and symbols of the parameters of a positioning test, by the edition of the standard.

Sources: ISO 230-2:1988 (clauses 2.10 to 2.13 and 6), ISO 230-2:1997 (2.13, 2.14, 2.18 to 2.23), ISO
230-2:2006 (2.13, 2.14, 2.18 to 2.24) and GOST 27843-2006, a modified translation of the 1997 text
(3.13 to 3.23). The text of 2014 was not available; its terms are those of `PARAMETERS`. The arrows
in these texts are ↑ for approaches in + (positive) and ↓ for approaches in − (1997, 2.6).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from compwright.reporting.numbers import PARAMETERS, symbol
from compwright.words.sentences import Sentence

_1988: Final = {
    "A": "Accuracy",
    "R": "Bidirectional repeatability of positioning",
    "R_positive": "Unidirectional repeatability of positioning",
    "R_negative": "Unidirectional repeatability of positioning",
    "B_mean": "Mean reversal error",
}
_1997: Final = {
    "A": "Bidirectional accuracy of positioning",
    "A_positive": "Unidirectional accuracy of positioning",
    "A_negative": "Unidirectional accuracy of positioning",
    "E": "Bidirectional systematic positional deviation",
    "E_positive": "Unidirectional systematic positional deviation",
    "E_negative": "Unidirectional systematic positional deviation",
    "M": "Mean bidirectional positional deviation",
    "R": "Bidirectional repeatability of positioning",
    "R_positive": "Unidirectional repeatability of positioning",
    "R_negative": "Unidirectional repeatability of positioning",
    "B": "Reversal value",
    "B_mean": "Mean reversal value",
}
_WORDS: Final[Mapping[str, Mapping[str, str]]] = {
    "iso230-2:1988": _1988,
    "iso230-2:1997": _1997,
    "iso230-2:2006": {
        key: words.replace("Bidirectional", "Bi-directional").replace(
            "bidirectional", "bi-directional"
        )
        for key, words in _1997.items()
    },
    "gost27843:2006": _1997,
}


def parameter_term(parameter: str, standard: object) -> str | Sentence:
    """Return the term for a parameter in the ``standard`` (such as ``iso230-2:1997``), else ""."""
    if parameter not in PARAMETERS:
        return ""
    term = _WORDS.get(str(standard), {}).get(parameter, "")
    return Sentence(PARAMETERS[parameter][1].name, (("term", term),))


def has_arrows(standard: object) -> bool:
    """Whether the text of the ``standard`` marks directions with ↑ and ↓."""
    return str(standard) in _WORDS


def edition_symbol(parameter: str, standard: object) -> str:
    """Return the symbol of a parameter, with ↑ and ↓ if the ``standard`` uses them."""
    text = symbol(parameter)
    if not has_arrows(standard) or not parameter.endswith(("_positive", "_negative")):
        return text
    return text[:-1] + ("↑" if parameter.endswith("_positive") else "↓")
