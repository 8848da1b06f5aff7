"""What a solved state looks like to a person: reads records, computes no physics.

`terminal` writes the report, `balls_csv` the table of balls for a spreadsheet; `language` holds
what they say in English and in Brazilian Portuguese. Only `terminal` needs Rich.
"""
