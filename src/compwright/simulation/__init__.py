"""A virtual machine with known errors: what a laser would measure on it, as records and as
files.
"""
