"""The LinuxCNC virtual control: reads its files and returns the active correction."""
