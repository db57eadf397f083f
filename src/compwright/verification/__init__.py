"""Did the loaded table act, and is the axis good now."""
