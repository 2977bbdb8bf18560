"""What studio and designer agree, and what follows from it."""
