"""Whole parts of a count over a length that repeats, defined by the commands of a script."""
