"""The ISG virtual control: what an ISG kernel does with given files."""
