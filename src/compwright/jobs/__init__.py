"""Read a job file or a command line as a job. Paths stay as written."""
