"""The manifest: its model, extensions and schema; reading, writing and checks."""
