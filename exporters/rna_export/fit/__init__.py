"""`rna-fit`: the cheapest model that a scene needs, found and trained."""
