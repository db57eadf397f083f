"""The French catalogue. Terms: docs/terms.md."""

from __future__ import annotations

from typing import Final

from compwright.words.french import labels

SENTENCES: Final[dict[str, str]] = {
    **labels.SENTENCES,
}
