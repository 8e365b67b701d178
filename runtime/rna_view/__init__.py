"""`rna-view`: an asset in a browser page, served from here or exported for any web server."""
