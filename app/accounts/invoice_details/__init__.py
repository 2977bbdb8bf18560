"""What invoices say of a person who sells and of a studio that buys."""
