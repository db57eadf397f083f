"""What a job says of an axis that its control has no place for, by the control's definition."""

from __future__ import annotations

from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.text import VALUES
from compwright.foundations.findings import Finding
from compwright.jobs.idle_keys import idle_keys
from compwright.records.job import Job


def without_effect(job: Job, definition: Definition) -> list[Finding]:
    """Return what `idle_keys` says of a job; columns of tables on an equally spaced grid are named
    by the number of an axis.
    """
    statements = definition.statements
    systems = any("system" in statement.fields for statement in statements.values())
    return idle_keys(
        job, systems=systems, numbers=VALUES in statements and "datum" in statements[VALUES].fields
    )
