"""The form `environment`: lobes of the transport, trained from a package alone."""
