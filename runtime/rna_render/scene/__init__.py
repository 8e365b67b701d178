"""The scene file: its model, reading, and messages."""
