"""Extension of the grid family: cross-axis tables, and tables of an axis over itself."""
