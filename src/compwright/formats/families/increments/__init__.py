"""Whole steps by section in one array of points that all axes share."""
