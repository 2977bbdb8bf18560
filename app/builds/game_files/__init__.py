"""The approved game files, as `soundlist pull` and `soundlist why` fetch them."""
