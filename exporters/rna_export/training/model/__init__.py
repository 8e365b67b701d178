"""The neural asset in PyTorch: planes, input blocks, decoder."""
