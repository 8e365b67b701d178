"""What rna-view cannot do."""

from rna_sdk.errors import RnaError


class ViewError(RnaError):
    """A page cannot be served or exported."""
