"""Families of controls by the shape of their tables: a folder for each, one common interface."""
