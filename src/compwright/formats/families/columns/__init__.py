"""Columns in the user's own exported tables."""
