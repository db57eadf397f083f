"""Show documents as terminal text, plots, HTML and commissioning card, without computing."""
