"""The parser, streams, errors, wording and page server that all commands share."""
