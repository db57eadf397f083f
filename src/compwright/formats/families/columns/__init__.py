"""Corrections as columns in the user's own exported tables."""
