"""The HEIDENHAIN virtual control: what a HEIDENHAIN does with given files."""
