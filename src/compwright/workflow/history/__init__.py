"""Folders of results read back as entries of a history."""
