"""Remove names and remarks from measurement files. Readings, units and keywords stay."""
