"""One catalogue of sentences: what findings, verdicts and labels say, by name and values.

Nobody else words them. English is in `english`; a further language is one more module beside it.
"""
