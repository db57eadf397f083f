"""Copies of files without names and serial numbers."""
