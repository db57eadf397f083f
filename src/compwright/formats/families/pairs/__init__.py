"""Tables between axes in addition to those of a grid: an axis over itself, or over another."""
