"""Read the bytes of measurement files into records. The entry point is `reading.read_tests`."""
