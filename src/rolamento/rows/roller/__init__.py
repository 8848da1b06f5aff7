"""Rows of cylindrical, needle and tapered rollers; docs/theory/rollers.md.

`roller` balances one roller between the rings, `batch` many cases of a row and their ring,
`columns` makes their numbers, `row` is the row that `rolamento.rows.row` asks for.
"""
