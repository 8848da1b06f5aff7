"""What a solved state looks like to a person: reads records, computes no physics.

`terminal` writes the report, `balls_csv` the table of balls for a spreadsheet, `language` says it in
English or in Brazilian Portuguese. Rich is imported by `terminal` only.
"""
