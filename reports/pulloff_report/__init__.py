"""The report of a run of pulloff: reads records, draws figures, writes HTML and PDF."""
