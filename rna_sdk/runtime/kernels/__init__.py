"""Compiled kernels that fill decoder inputs and run layers; the trainer uses them, too."""
