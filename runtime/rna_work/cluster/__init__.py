"""Work on a Ray cluster, and files on stores that its machines share."""
