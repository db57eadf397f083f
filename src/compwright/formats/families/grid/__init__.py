"""Tables of values by index, or of rows by position, on one axis."""
