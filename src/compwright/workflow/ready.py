"""Load the modules that a second process needs before it has work; no more, so that it starts
quickly.
"""

from __future__ import annotations


def ready_for_axes() -> None:
    """Load what the work on an axis needs."""
    from compwright.fitting.solve import load_solver
    from compwright.planning import axis_tasks  # noqa: F401
    from compwright.reporting import axis_report  # noqa: F401

    load_solver()
