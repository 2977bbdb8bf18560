"""Operating: what the queue, the store and the workers do, for who runs the server and for each studio's producer."""
