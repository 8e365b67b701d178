"""Which rays and lights a capture has, and what they hit."""
