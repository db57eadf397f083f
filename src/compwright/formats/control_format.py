"""The one door to a control: its definition, its options and what its files say, bound once."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.schema import Definition
from compwright.formats.families.family import Family
from compwright.formats.families.shapes import family_of
from compwright.records.correction import ControlState


def control_format(
    definition: Definition,
    given: Mapping[str, object],
    state: ControlState | None = None,
    *,
    strict: bool = False,
) -> Family:
    """Return the control of a definition, its options settled.

    ``given`` may hold text from the command line; with a ``state``, an option that the control's
    own files answer takes that answer. ``strict``: every option of ``given`` was said by somebody.
    Raises UsageError with every fault: unknown option, a value of the wrong kind, one that
    contradicts the control's files.
    """
    return family_of(definition)(definition, given, state, strict=strict)
