"""Operating: what the queue, the store and the workers do, for operators and for each studio's producer."""
