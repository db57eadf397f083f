"""The public library: what ``import compwright`` gives, on the commands' own functions."""
