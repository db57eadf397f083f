"""The inputs of a job: the job file, measurements, states, circles."""
