"""Documents -> terminal, plots, HTML and the commissioning card. Computes nothing."""
