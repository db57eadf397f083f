"""The SINUMERIK virtual control: what a SINUMERIK does with given files."""
