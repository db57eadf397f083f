"""Russian texts about controls, keyed by the English texts in the definitions and in
`formats.families`.
"""

from __future__ import annotations

from typing import Final

from compwright.words.russian.controls import (
    columns,
    common,
    grid,
    increments,
    lists,
    pairs,
    refusals,
    wrapped,
)

TEXTS: Final[dict[str, str]] = {
    **columns.TEXTS,
    **grid.TEXTS,
    **increments.TEXTS,
    **lists.TEXTS,
    **pairs.TEXTS,
    **refusals.TEXTS,
    **common.TEXTS,
    **wrapped.TEXTS,
}
