"""A virtual machine with known errors. It gives the readings of a laser as records and as files."""
