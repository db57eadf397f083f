"""The text of control files: conversion of bytes to statements and back, and patches."""
