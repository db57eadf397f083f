"""The ISG virtual control: reads an ISG kernel's files and returns the active correction."""
