"""Reading vibration signals from files: WAV, CSV, NumPy, MATLAB, HDF5, Parquet and UFF 58."""
