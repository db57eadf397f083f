"""Open a control's files, decode them with two independent readers, and compare the results."""
