"""Where in a file something stands that a control cannot take."""

from __future__ import annotations

from compwright.foundations.errors import Fault


class OfLine:
    """What stands on a line of a file."""

    __slots__ = ()
    file: str
    line: int

    @property
    def shown(self) -> str:
        """What a fault shows as found where it says nothing else."""
        return ""

    def fault(self, message: str, *, expected: str = "", found: str = "") -> Fault:
        """Return a fault at this line."""
        return Fault(
            message=message,
            file=self.file,
            place=f"line {self.line}",
            expected=expected,
            found=found or self.shown,
            hint=("correct this line in a copy of the file, or export it from the control again"),
        )
