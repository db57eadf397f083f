"""The text of control files: convert bytes to statements and back, and change single values."""
