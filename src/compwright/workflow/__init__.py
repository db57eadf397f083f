"""The commands and the steps that they consist of. Only this package reads and writes files."""
