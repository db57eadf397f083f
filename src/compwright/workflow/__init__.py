"""The commands, one module each. Only this package reads and writes files."""
