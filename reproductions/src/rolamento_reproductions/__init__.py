"""Figures and tables of publications, computed anew: pictures, data and pages.

Each publication is an entry point of the group ``rolamento.reproductions``, by which
``rolamento reproduce`` finds it.
"""
