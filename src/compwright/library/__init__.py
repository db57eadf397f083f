"""The public library: what ``import compwright`` provides, based on the commands' own functions."""
