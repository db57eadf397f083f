"""The French catalogue of sentences. Terms: docs/terms.md."""

from __future__ import annotations

from typing import Final

from compwright.words.french import (
    card,
    controls,
    estimates,
    jobs,
    labels,
    loading,
    measurements,
    pages,
    parts,
    plans,
    states,
    tables,
    tests,
)

SENTENCES: Final[dict[str, str]] = {
    **card.SENTENCES,
    **estimates.SENTENCES,
    **jobs.SENTENCES,
    **labels.SENTENCES,
    **loading.SENTENCES,
    **measurements.SENTENCES,
    **pages.SENTENCES,
    **parts.SENTENCES,
    **plans.SENTENCES,
    **states.SENTENCES,
    **tables.SENTENCES,
    **tests.SENTENCES,
}
TEXTS: Final = controls.TEXTS
