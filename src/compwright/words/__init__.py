"""One catalogue of sentences: what findings, verdicts and labels say, by name and values.

No other room builds them. English is in `english`; each further language is one module: `german`,
`french`, `russian`. They hold the labels of reports; a sentence that one lacks is shown in English.
"""
