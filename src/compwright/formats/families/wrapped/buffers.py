"""The order in which the card allows tables to be defined and deleted (ERR003)."""

from __future__ import annotations

#: What must not exist while a table is defined.
BEHIND = {
    "COMP": ("TCOMP", "BLCOMP", "TBUF", "ROTARY", "LOOKAHEAD", "GATHER"),
    "BLCOMP": ("TBUF", "ROTARY", "LOOKAHEAD", "GATHER"),
    "TCOMP": (),
}
_SHORT = {"ROT": "ROTARY", "LOOK": "LOOKAHEAD", "GAT": "GATHER"}


class Buffers:
    """The buffers that scripts have defined so far, by name; for tables the motors."""

    def __init__(self) -> None:
        self.motors: dict[str, set[int]] = {}

    def define(self, name: str, motor: int = 0) -> None:
        """Add a buffer."""
        self.motors.setdefault(long_name(name), set()).add(motor)

    def delete(self, name: str, motor: int) -> None:
        """Remove a buffer; a missing one is no fault."""
        found = self.motors.get(long_name(name), set())
        found -= {motor, 0}

    def refuses(self, kind: str, motor: int) -> str:
        """Return why the card does not define a table; empty if it does."""
        mine = self.motors.get(kind, set())
        if motor in mine:
            return f"#{motor} has a {kind} already; delete it first"
        if any(other < motor for other in mine):
            return f"#{min(mine)}, a lower motor, has a {kind}"
        there = [name for name in BEHIND[kind] if self.motors.get(name)]
        return f"{', '.join(there)} was defined before it" if there else ""

    def keeps(self, kind: str, motor: int) -> str:
        """Return why the card does not delete a table; empty if it does."""
        mine = self.motors.get(kind, set())
        if motor in mine and any(other < motor for other in mine):
            return f"#{min(mine)}, a lower motor, has a {kind}"
        return ""


def long_name(name: str) -> str:
    """Return the whole name of a buffer."""
    return _SHORT.get(name.upper(), name.upper())
