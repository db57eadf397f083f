"""The FANUC virtual control: what a FANUC does with given files."""
