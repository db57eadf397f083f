"""Read a job file or command line as a `compwright.records.job.Job`. Paths stay as written."""
