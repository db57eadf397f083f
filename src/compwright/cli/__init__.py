"""The command line. Each command imports only what it needs, so that it starts quickly."""

from compwright.cli import (
    completing,
    controls,
    histories,
    jobs,
    measurements,
    qualification,
    redacting,
)
from compwright.cli.shell import main, run
from compwright.cli.words import compwright

__all__ = [
    "completing",
    "compwright",
    "controls",
    "histories",
    "jobs",
    "main",
    "measurements",
    "qualification",
    "redacting",
    "run",
]
