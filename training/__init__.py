"""What the weights of judgements are learned from: sounds and rooms made by our own code. No check imports it."""
