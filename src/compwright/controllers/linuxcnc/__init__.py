"""The LinuxCNC virtual control: what LinuxCNC does with given files."""
