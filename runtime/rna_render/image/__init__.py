"""Films, images and their files, denoising and display."""
