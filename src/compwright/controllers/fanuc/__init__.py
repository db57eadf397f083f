"""The FANUC virtual control: reads a FANUC's files and returns the active correction."""
