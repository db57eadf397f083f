"""Write what a verification proved as YAML lines for a job and for a control's definition."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

from compwright.foundations.utf8 import encoded

KEYS = ("control", "machine", "date", "how")


def proven_lines(entry: Mapping[str, str], heading: Sequence[str], indent: int) -> bytes:
    """Return the comment lines ``heading``, followed by the YAML key ``proven`` with one entry."""
    blanks = " " * indent
    lines = [*(f"# {_one_line(line)}" for line in heading), "proven:"]
    for place, key in enumerate(KEYS):
        mark = "- " if place == 0 else "  "
        lines.append(
            f"{blanks}{mark}{key}: {json.dumps(_one_line(entry[key]), ensure_ascii=False)}"
        )
    return encoded("\n".join(lines) + "\n")


def _one_line(text: str) -> str:
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())
