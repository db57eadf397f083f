"""What families say for the card of one table; the files that a commissioning card names: each is
there, and each written one is in a step.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from compwright.formats.families.card_texts import AxisCard, CardRequest
from compwright.formats.families.family import Family
from compwright.records.axis import Axis, FloatArray
from compwright.records.correction import AxisCompensation, ControlFile, no_compensation
from compwright.records.facts import AxisFacts

_FILE = re.compile(r"(?<![\w/.-])[\w-]+\.(?:INI|TXT|NC|MPF|SPF|COM|CMA|comp|ini|pmc|lis|csv)\b")


def wrong_files(results: Path) -> list[str]:
    """Give what is wrong with the files that the steps of the card in a folder of results name."""
    card = (results / "card" / "card.md").read_text(encoding="utf-8").replace("\\", "")
    begin = card.index("## Steps")
    steps = card[begin : card.index("\n## ", begin)]
    tables = [path for path in (results / "tables").rglob("*") if path.is_file()]
    there = {path.name for path in results.rglob("*") if path.is_file()}
    named = set(_FILE.findall(steps))
    whole = any(f"tables/{path.parent.name}" in steps for path in tables)
    idle = set() if whole else {path.name for path in tables} - named
    return [
        *(f"{name} is named and not there" for name in sorted(named - there)),
        *(f"{name} is in no step" for name in sorted(idle)),
    ]


def card_of(
    control: Family,
    axis: Axis,
    table: AxisCompensation,
    facts: AxisFacts = AxisFacts(),  # noqa: B008 - frozen
    at: FloatArray | None = None,
) -> AxisCard:
    """Give the card of a table, checked at its own nodes unless others are given."""
    where = table.positions if at is None else at
    return control.card(CardRequest(axis=axis, table=table, facts=facts, check_at=where))


def card_values(
    control: Family,
    axis: Axis,
    table: AxisCompensation,
    facts: AxisFacts = AxisFacts(),  # noqa: B008 - frozen
    at: FloatArray | None = None,
) -> Mapping[str, str]:
    """Give the values of such a card."""
    return card_of(control, axis, table, facts, at).values


def named_in_card(control: Family, axis: Axis, files: Sequence[ControlFile]) -> Mapping[str, str]:
    """Give the values of the card of an empty table for which these files were written."""
    table = no_compensation(axis.address, axis.kind)
    asked = CardRequest(
        axis=axis, table=table, facts=AxisFacts(), check_at=np.array([0.0]), files=files
    )
    return control.card(asked).values
