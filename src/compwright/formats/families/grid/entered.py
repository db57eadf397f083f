"""Values in the files of a control with tables by index or position: LinuxCNC."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from compwright.formats.definition.schema import Definition
from compwright.formats.text.entered import Entered, by_statements
from compwright.records.correction import ControlFile

#: Keys other than those of the definition that decide the scale of a joint or move its zero
#: (LinuxCNC documentation, INI configuration: [JOINT_n], [KINS]).
_CORRECTING = re.compile(
    r"\[(?:JOINT_[0-9]+|KINS)\] (?:(?:INPUT_|OUTPUT_)?SCALE|HOME|HOME_OFFSET|KINEMATICS)"
)


def entered(
    definition: Definition, files: Sequence[ControlFile], _: Sequence[ControlFile] = ()
) -> dict[str, Entered]:
    """Return every value of the files."""
    return {
        key: replace(
            entry, relevant=entry.relevant or _CORRECTING.fullmatch(entry.group) is not None
        )
        for key, entry in by_statements(definition, files).items()
    }
