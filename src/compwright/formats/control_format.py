"""Entry to a control's format: definition, options and the contents of its files, bound
together.
"""

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
    """Return the control of a definition with its options resolved.

    ``given`` may hold text from the command line; with a ``state``, an option that the control's
    own files answer takes that answer. ``strict``: every option of ``given`` was given by the user.
    Raises UsageError with every fault: unknown option, wrong type, contradiction to the control's
    files.
    """
    return family_of(definition)(definition, given, state, strict=strict)
