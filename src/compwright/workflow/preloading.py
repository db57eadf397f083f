"""Load only the modules that a parallel process needs, so that the process starts quickly."""

from __future__ import annotations


def ready_for_axes() -> None:
    """Load the modules that a new process needs to work on an axis."""
    from compwright.fitting.solve import load_solver
    from compwright.planning import axis_tasks  # noqa: F401
    from compwright.reporting import axis_report  # noqa: F401

    load_solver()
