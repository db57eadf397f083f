"""The parameters of a circular test as text, next to the values that the vendor printed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

from compwright.reporting.numbers import MISSING, decimals_of_unit, number, plain
from compwright.words.sentences import Sentence, say

#: Rows of the parameter table: letter, whether about the least-squares centre, keys for ccw, cw
#: and both.
_ROWS: Final = (
    ("G", "", ("G_ccw", "G_cw", "G_bidirectional")),
    ("", "G_lsc", ("G_ccw_lsc", "G_cw_lsc", "G_bidirectional_lsc")),
    ("F max", "", ("F_max_ccw", "F_max_cw", "")),
    ("F min", "", ("F_min_ccw", "F_min_cw", "")),
    ("", "F_max_lsc", ("F_max_ccw_lsc", "F_max_cw_lsc", "")),
    ("", "F_min_lsc", ("F_min_ccw_lsc", "F_min_cw_lsc", "")),
    ("H", "", ("", "", "H")),
    ("D", "", ("", "", "D")),
)
#: What Renishaw software prints under an edition of ISO 230-4: letter, names for ccw, cw and both.
_PRINTED: Final = (
    (
        "G",
        (
            "AF_CIRCULAR_DEVIATION_CCW",
            "AF_CIRCULAR_DEVIATION_CW",
            "AF_BIDIRECTIONAL_CIRCULAR_DEVIATION",
            "AF_CIRCULAR_DEVIATION_BIDIRECTIONAL",
        ),
    ),
    ("F max", ("AF_MAX_RADIAL_DEVIATION_CCW", "AF_MAX_RADIAL_DEVIATION_CW")),
    ("F min", ("AF_MIN_RADIAL_DEVIATION_CCW", "AF_MIN_RADIAL_DEVIATION_CW")),
    ("H", ("AF_CIRCULAR_HYSTERESIS",)),
    ("D", ("AF_MEAN_BIDIRECTIONAL_RADIAL_DEVIATION",)),
)


@dataclass(frozen=True, slots=True)
class ParameterRow:
    """A row of parameters of a circular test: its name, letter, and keys for ccw, cw and both."""

    words: Sentence
    letter: str
    keys: tuple[str, str, str]

    @property
    def signed(self) -> bool:
        """Whether the values can be negative, so that a sign is printed."""
        return self.keys[0][:1] == "F" or self.letter == "D"


def parameter_rows(result: Mapping[str, Any]) -> list[ParameterRow]:
    """Return the rows of parameters that have a value. A row with the same values as an earlier row
    is left out.
    """
    values = result.get("parameters") or {}
    rows = []
    for letter, name, keys in _ROWS:
        own = keys[0].removesuffix("_lsc")
        twice = own != keys[0] and own[0] == "F" and values.get(own) == values.get(keys[0])
        if not twice and any(values.get(key) is not None for key in keys):
            words = say("circle.parameter", name=name or letter.replace(" ", "_"))
            rows.append(ParameterRow(words, letter, keys))
    return rows


def printed_parameters(result: Mapping[str, Any]) -> dict[str, str]:
    """Return the parameters (µm) that the vendor's software printed, by letter, for the edition of
    ISO 230-4 by which the test is evaluated.
    """
    edition = str(result.get("standard")).rpartition(":")[2]
    block = (result.get("vendor") or {}).get(f"ISO230_4 {edition}")
    if not isinstance(block, Mapping):
        return {}
    found = {
        letter: [
            plain(block[name]["value"]) for name in names if isinstance(block.get(name), Mapping)
        ]
        for letter, names in _PRINTED
    }
    return {letter: " / ".join(values) for letter, values in found.items() if values}


def parameter_words(key: str) -> Sentence:
    """Return the text for a parameter on a page (``F_max_ccw_lsc`` -> ``F max ccw, least-squares
    centre``).
    """
    letter, _, rest = key.removesuffix("_lsc").partition("_")
    words = rest.split("_") if rest else []
    sense = next((word for word in words if word in ("bidirectional", "ccw", "cw")), "")
    return say(
        "circle.symbol",
        letter=" ".join([letter, *(word for word in words if word != sense)]),
        sense=sense,
        centre=letter if key.endswith("_lsc") else "",
    )


def squareness_limit(circle: Mapping[str, Any]) -> dict[str, Any]:
    """Return the check of the corrected squareness of a verified circle in the form of a limit, by
    the name of the cause. The limits are U to both sides of the expected value; a rest beyond them
    that is accepted as negligible (CW-V035) has none. Empty without such a check.
    """
    check = circle.get("squareness") if "after" in circle else None
    if not check:
        return {}
    decimals = decimals_of_unit("µm/m")
    expected, U = check["expected"], check["U"]
    if check["decision"] == "accept" and abs(check["value"] - expected) > U:
        return {"squareness": {**check, "limit": MISSING}}
    low, high = (number(expected + part * U, decimals) for part in (-1.0, 1.0))
    return {"squareness": {**check, "limit": say("label.range", low=low, high=high)}}
