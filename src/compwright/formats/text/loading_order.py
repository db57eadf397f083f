"""Order in which a control loads its files."""

from __future__ import annotations

import re
from collections.abc import Sequence

from compwright.formats.definition.schema import Definition
from compwright.formats.text.container import is_container
from compwright.records.correction import ControlFile

#: What makes tables act, and while it does protects their values from being written.
_SWITCHES = ("enabled", "cross_table_enabled", "cross_axis_enabled")
_VALUES = ("value", "cross_value")


def loading_order(definition: Definition, files: Sequence[ControlFile]) -> list[str]:
    """Return the names of files in the order in which a control loads them all: a whole archive
    before the files over it, values before the switches that protect them.
    """

    def holds(file: ControlFile, quantity: str) -> bool:
        binding = definition.bindings.get(quantity)
        if binding is None:
            return False
        form = definition.statements[binding.statement].form.split("[", 1)[0].encode()
        return re.search(re.escape(form) + rb"\s*\[", file.content) is not None

    def place(file: ControlFile) -> tuple[bool, bool, bool]:
        return (
            not is_container(file),
            any(holds(file, name) for name in _SWITCHES),
            not any(holds(file, name) for name in _VALUES),
        )

    return [
        file.name
        for file in (sorted(files, key=place) if "enabled" in definition.bindings else files)
    ]
