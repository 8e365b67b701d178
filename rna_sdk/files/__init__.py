"""Files and folders: checked before they are read, written whole, marked by their owner."""
