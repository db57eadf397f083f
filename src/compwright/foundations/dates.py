"""Read dates as instruments write them, but no date that can be read as two different days."""

from __future__ import annotations

import re
from datetime import date

_MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
_TIME = (
    r"(?:[T,\s-]+(?P<h>\d{1,2}):?(?P<n>\d{2})(?::?(?P<s>\d{2})(?:[.,]\d+)?)?"
    r"(?:\s*(?P<half>[ap])\.?\s?m\b)?.*)?"
)
_FORMS = tuple(
    re.compile(rf"\s*{form}{_TIME}\s*", re.IGNORECASE)
    for form in (
        r"(?P<y>\d{4})(?P<sep>[-/.])(?P<m>\d{1,2})(?P=sep)(?P<d>\d{1,2})",
        r"(?P<y>\d{4})(?P<m>\d{2})(?P<d>\d{2})",
        r"(?P<d>\d{1,2})\.\s?(?P<m>\d{1,2})\.\s?(?P<y>\d{4})",
        r"(?P<d>\d{1,2})[-\s]+(?P<name>[a-z]{3})[a-z]*\.?,?[-\s]+(?P<y>\d{4})",
        r"(?P<name>[a-z]{3})[a-z]*\.?\s+(?P<d>\d{1,2}),?\s+(?P<y>\d{4})",
    )
)
_SLASHES = re.compile(rf"\s*(?P<a>\d{{1,2}})[/-](?P<b>\d{{1,2}})[/-](?P<y>\d{{4}}){_TIME}\s*")


def day_of(text: str) -> str:
    """Return a date as ``YYYY-MM-DD`` (with `` HH:MM:SS`` if known), or "" if it is ambiguous."""
    for form in _FORMS:
        found = form.fullmatch(text)
        if found is None:
            continue
        parts = found.groupdict()
        name = (parts.get("name") or "").lower()
        if name and name not in _MONTHS:
            return ""
        month = _MONTHS.index(name) + 1 if name else int(parts["m"])
        return _written(int(parts["y"]), month, int(parts["d"]), parts)
    found = _SLASHES.fullmatch(text)
    if found is None:
        return ""
    one, other = int(found["a"]), int(found["b"])
    if one != other and one <= 12 and other <= 12:
        return ""
    month, day = (one, other) if one <= 12 else (other, one)
    return _written(int(found["y"]), month, day, found.groupdict())


def _written(year: int, month: int, day: int, parts: dict[str, str | None]) -> str:
    try:
        text = date(year, month, day).isoformat()
    except ValueError:
        return ""
    if parts["h"] is None or parts["n"] is None:
        return text
    hour = int(parts["h"])
    if parts["half"] and 1 <= hour <= 12:  # 12:10 am is ten past midnight
        hour = hour % 12 + (12 if parts["half"].lower() == "p" else 0)
    return f"{text} {hour:02d}:{parts['n']}:{parts['s'] or '00'}"
