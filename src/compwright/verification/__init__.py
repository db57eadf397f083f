"""Decision whether the loaded table is active, and whether the axis keeps its limits now."""
