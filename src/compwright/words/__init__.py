"""One catalogue of sentences: what findings, verdicts and labels say, by name and values.

No other room builds them. English is in `english`; a further language is one more module beside it.
"""
