"""The Russian catalogue. Terms: docs/terms.md."""

from __future__ import annotations

from typing import Final

from compwright.words.russian import labels

SENTENCES: Final[dict[str, str]] = {
    **labels.SENTENCES,
}
