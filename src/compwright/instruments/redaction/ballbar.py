"""A ballbar's XML without what is somebody's: known elements and attributes with numbers, dates and
words of a closed list; all other elements, remarks and instructions are left out.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Final
from xml.sax.saxutils import escape, quoteattr

from compwright.foundations.redaction import Cuts
from compwright.instruments.redaction.words import is_axis, is_date, is_keywords, is_numbers
from compwright.instruments.safe_xml import Element, read_xml

Kept = Callable[[str], bool]
_VERSION: Final = re.compile(r"[0-9]{1,4}(?:\.[0-9]{1,6}){0,4}")
_PRODUCT: Final = re.compile(
    r"(?:Renishaw|(?:Renishaw )?Ballbar(?: (?:5|20|Trace))?|QC10|QC20|QC20-W|BALLBAR_CALIBRATOR"
    r"|virtual ballbar|compwright)",
    re.IGNORECASE,
)
_VIEW: Final = re.compile(r"[+-][AB][+-][AB]")
_PLANE: Final = re.compile(r"[A-Z]{2}")
#: Pieces of the names that the instrument's software gives its results.
_PIECES: Final = frozenset(
    {
        *("4", "5", "54", "57", "1996", "2005", "A", "AF", "ANSI", "B", "BACKLASH"),
        *("BEST", "BIDIRECTIONAL", "CALCULATED", "CCW", "CENTRE", "CHANGE", "CIRCULAR"),
        *("CIRCULARITY", "COMMENT", "CW", "CYCLIC", "DEVIATION", "DIAGNOSTICS", "ERROR"),
        *("ERRORS", "FAILED", "FEEDRATE", "FWD", "GLOBAL", "HYSTERESIS", "IC", "ISO230"),
        *("JIS", "LATERAL", "LENGTH", "LOCATION", "LOWER", "MAX", "MEAN", "MIN"),
        *("MISMATCH", "MM", "NEG", "NON", "OFFSET", "OK", "PERC", "PERCENT", "PHASE"),
        *("PITCH", "PLAY", "POS", "POSITIONAL", "PRE", "POST", "RADIAL", "RADIUS"),
        *("RANK", "RANKING", "READINGS", "RENISHAW", "REV", "REVERSAL", "RMS"),
        *("ROUNDNESS", "SCALE", "SERVO", "SHIFT", "SIMULATED", "SIN", "SPIKES"),
        *("SQUARENESS", "STRAIGHTNESS", "TEST", "THETA", "TOLERANCE", "UM", "UPPER"),
        *("UT", "ANGLE", "VOLUMETRIC", "WARNING"),
    }
)


def _named(text: str) -> bool:
    return all(piece in _PIECES for piece in text.upper().replace("-", "_").split("_"))


def _pattern(pattern: re.Pattern[str]) -> Kept:
    return lambda text: pattern.fullmatch(text.strip()) is not None


def _never(_: str) -> bool:
    return False


#: Elements that stay, with what their text may be; None: they have no text of their own.
_ELEMENTS: Final[Mapping[str, Kept | None]] = {
    **dict.fromkeys(
        (
            *("TEST_DOCUMENT", "TEST_SPEC", "INSTRUMENT", "DYNAMIC_BALLBAR", "PLANE", "RUN_SPEC"),
            *("FEATURE_SPEC", "TOLERANCE", "AVERAGING", "ANALYSIS_SPEC", "ANALYSIS", "EQUIPMENT"),
            *("BALLBAR", "CALIBRATOR", "SOFTWARE", "RUN_RESULTS", "BALLBAR_RUN", "MACHINE_TESTED"),
        )
    ),
    **dict.fromkeys(
        (
            *("NOMINAL_LENGTH", "PROGRAMMED_FEEDRATE", "START_ANGLE", "END_ANGLE", "CENTRE"),
            *("OVERSHOOT_ANGLE", "TEST_RADIUS", "LOWER_LIMIT", "UPPER_LIMIT", "SAMPLE_RATE"),
            *("SPINDLE_NUMBER", "TEMP_MATERIAL_COEFFICIENT", "SCALE_FACTOR", "TEMPERATURE"),
            *("CALIBRATED_LENGTH", "EXPANSION_COEFFICIENT", "READINGS", "START_INDEX"),
            *("END_INDEX", "RUN_TEMPERATURE", "SIMULATION", "NUMBER_OF_ERRORS"),
            "NUMBER_OF_WARNINGS",
        ),
        is_numbers,
    ),
    **dict.fromkeys(("DATE_STARTED", "DATE_COMPLETED", "LAST_CALIBRATED"), is_date),
    **dict.fromkeys(("A_AXIS_NAME", "B_AXIS_NAME"), is_axis),
    **dict.fromkeys(("MANUFACTURER", "MODEL", "AUTHOR", "TITLE"), _pattern(_PRODUCT)),
    **dict.fromkeys(("OPERATOR", "COMMENT", "NC_PROGRAM_ID"), _never),
    **dict.fromkeys(("SERIAL_NUMBER", "CERTIFICATE_NUMBER"), _never),
    "RUN_DIRECTION": lambda text: text.upper() in {"CW", "CCW"},
    "VERSION": _pattern(_VERSION),
    "FEATURE": lambda text: is_numbers(text) or is_keywords(text),
}
#: Attributes that stay, with what they may be.
_ATTRIBUTES: Final[Mapping[str, Kept]] = {
    **dict.fromkeys(("CALIBRATION_REQUIRED", "ENABLED", "VALID"), is_keywords),
    **dict.fromkeys(("DT", "STATUS", "LEVEL"), _named),
    **dict.fromkeys(("MANUFACTURER", "MODEL"), _pattern(_PRODUCT)),
    "VIEW": _pattern(_VIEW),
    "TEST_PLANE": _pattern(_PLANE),
    "VERSION": _pattern(_VERSION),
}
#: Words of the elements, attributes and names, in small letters.
ELEMENT_WORDS: Final = frozenset(
    piece.lower()
    for name in (*_ELEMENTS, *_ATTRIBUTES, *_PIECES, "Ballbar_Trace", "QC10", "QC20")
    for piece in name.split("_")
)
#: What the texts and names of elements are called in the count.
_KINDS: Final = {
    "OPERATOR": "operator",
    "COMMENT": "comment",
    "SERIAL_NUMBER": "serial number",
    "CERTIFICATE_NUMBER": "serial number",
    "MACHINE_TESTED": "machine",
    "NC_PROGRAM_ID": "program",
    "TEST_SPEC": "title",
}


def redacted_ballbar(content: bytes, file: str, cuts: Cuts) -> bytes:
    """Return a ballbar's file without what is somebody's, in UTF-8.

    Raises InputError for what is no XML.
    """
    root = read_xml(content, file)
    lines = ['<?xml version="1.0" encoding="utf-8"?>', *_lines(root, 0, cuts), ""]
    return "\n".join(lines).encode()


def _lines(element: Element, depth: int, cuts: Cuts) -> list[str]:
    indent = "  " * depth
    start = "".join(
        f" {name}={quoteattr(_attribute(element.tag, name, value, cuts))}"
        for name, value in element.attributes.items()
        if _is_known(name, value, cuts)
    )
    text = escape(_text(element, cuts))
    if not element.children:
        return [f"{indent}<{element.tag}{start}>{text}</{element.tag}>"]
    lines = [f"{indent}<{element.tag}{start}>{text}"]
    for child in element.children:
        if child.tag in _ELEMENTS:
            lines += _lines(child, depth + 1, cuts)
        else:
            _left_out(child, cuts)
    return [*lines, f"{indent}</{element.tag}>"]


def _text(element: Element, cuts: Cuts) -> str:
    kept = _ELEMENTS[element.tag]
    if not element.text or (kept is not None and kept(element.text)):
        return element.text
    kind = _KINDS.get(element.tag, "name")
    return (cuts.remark if kind == "comment" else cuts.name)(element.text, kind)


def _is_known(name: str, value: str, cuts: Cuts) -> bool:
    if name.upper() in _ATTRIBUTES or name == "NAME":
        return True
    cuts.remark(value, "attribute")
    return False


def _attribute(tag: str, name: str, value: str, cuts: Cuts) -> str:
    kept = _named if name == "NAME" else _ATTRIBUTES[name.upper()]
    somebody = name == "NAME" and tag in {"MACHINE_TESTED", "TEST_SPEC"}
    if not value or (kept(value) and not somebody):
        return value
    return cuts.name(value, _KINDS.get(tag, "name"))


def _left_out(element: Element, cuts: Cuts) -> None:
    cuts.removed.append(("element", element.tag))
    for text in (element.text, *element.attributes.values()):
        cuts.remark(text, "element")
    for child in element.children:
        _left_out(child, cuts)
