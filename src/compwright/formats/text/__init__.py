"""Text of control files: bytes to statements and back, and patches."""
