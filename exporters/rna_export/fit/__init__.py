"""`rna-fit`: finds and trains the cheapest model within a limit."""
