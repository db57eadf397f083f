"""German texts for controls, from their definitions and families, keyed by the English texts."""

from __future__ import annotations

from typing import Final

from compwright.words.german.controls import (
    columns,
    grid,
    increments,
    lists,
    pairs,
    shared,
    wrapped,
)

TEXTS: Final[dict[str, str]] = {
    **columns.TEXTS,
    **grid.TEXTS,
    **increments.TEXTS,
    **lists.TEXTS,
    **pairs.TEXTS,
    **shared.TEXTS,
    **wrapped.TEXTS,
}
