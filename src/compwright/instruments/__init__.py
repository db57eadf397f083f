"""Measurement files to records: bytes in, records out. The entry is
`compwright.instruments.reading`.
"""
