"""Decide whether the loaded table was active, and whether the axis is good now."""
