"""Joint work: two contracts that share one price, one for each designer, agreed together."""
