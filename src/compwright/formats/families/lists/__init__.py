"""Entries by index in one list per axis, whose header names the axis."""
