"""Copies without names."""
