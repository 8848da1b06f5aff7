"""Braga and Almeida, relative motions: what is computed, part by part."""
