"""What an asset will gain in scenes, told before its capture starts."""
