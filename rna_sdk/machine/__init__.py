"""The machine of this process: its cores, memory and threads, and kernels compiled for it."""
