"""Files of people and of other programs: texts and tables, what is written, shipped data, JSON.

`text` reads case files, `tables` every table that people or recorders write, `columns` knows their
headings, `dates` their moments. `foreign` bounds and isolates what reads other programs' files.
"""
