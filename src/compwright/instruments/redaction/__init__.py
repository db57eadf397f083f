"""Measurement files without names and remarks: readings, units and keywords stay."""
