"""A virtual machine with known errors, which gives readings of instruments as records and files."""
