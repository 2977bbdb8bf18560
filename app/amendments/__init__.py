"""Changes to an agreed contract: change orders, notice, and the settlement of an early end."""
