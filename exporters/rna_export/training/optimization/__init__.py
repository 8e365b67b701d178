"""Steps of training: batches, losses, optimizers and their kernels."""
