"""Checks that every definition has to pass."""
