"""Tables between axes beside those of a grid: an axis over itself, or over another."""
