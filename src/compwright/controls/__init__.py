"""Open control files, decode them with two independent file readers, and compare the results."""
