"""Values with their place in a file (file and line), which faults show."""

from __future__ import annotations

from compwright.foundations.errors import Fault


class OfLine:
    """A value that was read from one line of a file, with file and line number."""

    __slots__ = ()
    file: str
    line: int

    @property
    def shown(self) -> str:
        """The value as text for faults; a fault shows it as ``found`` unless `fault` is given
        another text.
        """
        return ""

    def fault(self, message: str, *, expected: str = "", found: str = "") -> Fault:
        """Return a fault with the file and line of this value."""
        return Fault(
            message=message,
            file=self.file,
            place=f"line {self.line}",
            expected=expected,
            found=found or self.shown,
            hint=("correct this line in a copy of the file, or export it from the control again"),
        )
