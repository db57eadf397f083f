"""Shapes of compensation tables, a folder per family behind one protocol."""
