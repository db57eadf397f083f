"""One module per command; the only room that touches the file system."""
