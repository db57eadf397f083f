"""The text of control files: bytes to statements and back; the one patcher."""
