"""Extension of the grid family: tables between axes, and tables of an axis over itself."""
