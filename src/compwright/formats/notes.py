"""What is collected while files are read, and the sentences that several readers say: each finding code is made in one place."""

from __future__ import annotations

from dataclasses import dataclass, field

from compwright.foundations.errors import Fault
from compwright.foundations.findings import Finding
from compwright.records.correction import Assumption


@dataclass(slots=True)
class Notes:
    """What is collected while files are read."""

    faults: list[Fault] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    assumed: list[Assumption] = field(default_factory=list)

    def assume(self, fact: str, value: str, evidence: str) -> None:
        """Note an assumption once."""
        note = Assumption(fact, value, evidence)
        if note not in self.assumed:
            self.assumed.append(note)

    def find(self, code: str, severity: str, message: str) -> None:
        """Note a finding."""
        self.findings.append(Finding(code, "warning" if severity == "warning" else "info", message))

    def counted_as(self, label: str, name: str, value: str) -> None:
        """Note that a quantity is not in the files, and what it was counted as."""
        self.find("CW-S005", "warning", f"{label}: {name} is not in the files; counted as {value}")

    def switched_off(self, label: str, what: str) -> None:
        """Note that a table of the files corrects nothing; ``what`` says by what it is off."""
        self.find("CW-S007", "info", f"{label}: {what}; it corrects nothing")

    def no_table(self, label: str) -> None:
        """Note that no file holds a table of an axis."""
        self.find("CW-S008", "warning", f"{label}: no file holds a table; counted as none")

    def taken_for(self, axis: str, address: str) -> None:
        """Note which axis of the control an axis of the job was taken for."""
        self.find("CW-S010", "warning", f"axis {axis} is taken as {address} of the control: check it, or give its address")

    def ignored(self, label: str, what: str, why: str) -> None:
        """Note a value that the control ignores."""
        self.find("CW-S009", "warning", f"{label}: {what} is ignored by the control: {why}")

    def idle_file(self, message: str) -> None:
        """Note that a table file and what the control loads do not fit."""
        self.find("CW-S012", "warning", message)
