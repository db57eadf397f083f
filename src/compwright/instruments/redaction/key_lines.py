"""Key lines (``# axis: X``, ``Machine: VMC 850``): which keys and which values stay."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Final

from compwright.foundations.redaction import NEUTRAL, Cuts
from compwright.instruments.comments import comment_text
from compwright.instruments.redaction.words import (
    is_axis,
    is_date,
    is_keywords,
    is_numbers,
    is_quantity,
)

Kept = Callable[[str], bool]
_FORM: Final = re.compile(r"(?:positioning|circular)\s+[0-9]{1,9}", re.IGNORECASE)
_KEY: Final = re.compile(r"(?P<key>[^\W\d_][\w .()/-]*?)\s*:(?!//)\s*(?P<value>.*)")
_PLANE: Final = re.compile(r"[A-Za-z][0-9]{0,2}[ ,/-]?[A-Za-z][0-9]{0,2}")


def _never(_: str) -> bool:
    return False


#: Keys whose values stay where they are what they should be.
VALUES: Final[Mapping[str, Kept]] = {
    **dict.fromkeys(("axis", "axis as written"), is_axis),
    **dict.fromkeys(("date", "date_started", "date_completed", "start date", "time"), is_date),
    **dict.fromkeys(("datum", "messdatum", "uhrzeit", "datum/uhrzeit"), is_date),
    **dict.fromkeys(("temperature", "temperatur", "air_temperature"), is_quantity),
    **dict.fromkeys(("unit", "units", "cycle", "deviation", "compensated_for"), is_keywords),
    **dict.fromkeys(("calibrated", "direction", "instrument"), is_keywords),
    **dict.fromkeys(("nominal_radius_mm", "feed_mm_min", "centre", "targets", "runs"), is_numbers),
    **dict.fromkeys(("t_m", "t_m_start", "t_m_end", "t_d", "t_d_start", "t_d_end"), is_quantity),
    "compwright": lambda text: _FORM.fullmatch(text) is not None,
    "plane": lambda text: _PLANE.fullmatch(text.strip()) is not None,
    "simulated": _never,
}
#: Keys whose values are somebody's: what they are called in the count.
NAMES: Final[Mapping[str, str]] = {
    "machine": "machine",
    "serial": "serial number",
    "serial_no": "serial number",
    "operator": "operator",
    "by": "operator",
    "instrument": "instrument",
}


def redacted_comment(line: str, cuts: Cuts) -> str | None:
    """Return a comment line without what is somebody's, None for a line that is no comment."""
    text = comment_text(line)
    if text is None:
        return None
    if not line.lstrip(' "').startswith("#"):
        return line  # sep=;
    match = _KEY.fullmatch(text)
    if match is None:
        return f"# {cuts.remark(text)}".rstrip()
    key = re.sub(r"[ -]+", "_", match["key"]).lower()
    if key not in VALUES and key not in NAMES:
        return f"# {cuts.remark(text)}".rstrip()
    return f"# {match['key']}: {redacted_value(key, match['value'], cuts)}".rstrip()


def redacted_value(key: str, value: str, cuts: Cuts, values: Mapping[str, Kept] = VALUES) -> str:
    """Return the value of a key that is known, or what stands in its place."""
    kept = values.get(key)
    if not value or (kept is not None and kept(value)):
        return value
    if key == "simulated":
        return NEUTRAL if cuts.remark(value) else ""
    return cuts.name(value, NAMES.get(key, "name"))
