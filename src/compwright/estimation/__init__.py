"""The error of an axis with its uncertainty, estimated from a positioning test."""
