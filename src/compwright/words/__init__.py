"""The catalogue of sentences: texts of findings, verdicts and labels, by name and values.

No other package builds them. Each language is a folder with the same modules: `english`, `german`,
`french`, `russian`.
"""
