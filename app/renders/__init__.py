"""Game files made from masters, and the pictures and previews that a review needs."""
