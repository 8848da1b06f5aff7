"""Rows of rolling elements: each kind held at a place, answering force and stiffness."""
