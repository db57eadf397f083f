"""From test results to decisions: the wanted correction, the table, and the change that it will
make.
"""
