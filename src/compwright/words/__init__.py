"""One catalogue of sentences: what findings, verdicts and labels say, by name and values.

No other room builds them. Each language is a folder with the same modules: `english`, `german`,
`french`, `russian`.
"""
