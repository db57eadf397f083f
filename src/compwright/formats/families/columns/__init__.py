"""Columns in tables of the user's own making."""
