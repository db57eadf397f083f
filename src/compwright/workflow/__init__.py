"""The commands, one module each. Only this room touches the file system."""
