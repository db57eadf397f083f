"""What a job brings: the job file, measurements, states, circles."""
