"""Job file or command line -> `compwright.records.job.Job`. Reads bytes and text only; paths stay
as written.
"""
