"""The PMAC virtual control: what a PMAC does with given files."""
