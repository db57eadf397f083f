"""Decision whether the loaded table is active, and whether the axis is now within its limits."""
