"""Rows of rolling elements on one ring: sets, preload, springs, and the result of them all."""

from rolamento.system.cases import Cases, spread
from rolamento.system.solve import Balanced, balance, result, solve_cases

__all__ = ["Balanced", "Cases", "balance", "result", "solve_cases", "spread"]
