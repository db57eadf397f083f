"""The PMAC virtual control: executes its scripts and returns the active correction."""
