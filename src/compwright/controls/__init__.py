"""Access to a control: open its files, decode them with two independent readers, compare the
results.
"""
