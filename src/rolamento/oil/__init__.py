"""The oil itself: viscosity over temperature and pressure, density.

A model a function, of numbers or arrays in SI units; nothing here knows a bearing.
"""
