"""What a bearing's vibration says: fault frequencies, synthetic signals, analysis and diagnosis.

`signal` holds the record of a measured or synthesised signal that all others read or return.
"""
