"""Shapes of compensation tables: one folder per family, all with the same interface."""
