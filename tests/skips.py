"""What was skipped and why, in one line."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable


def skipped_line(reasons: Iterable[str]) -> str:
    """Return how many tests were skipped for each of the ``reasons``, the most frequent first; empty
    for none.
    """
    counts = Counter(reason.removeprefix("Skipped: ") for reason in reasons)
    each = "; ".join(f"{count} ({reason})" for reason, count in counts.most_common())
    return f"skipped: {each}" if each else ""
