"""Measurement files to records: bytes in, records out. The door is
`compwright.instruments.reading`.
"""
