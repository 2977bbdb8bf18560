"""The deletion of masters when their contracts' retention period is over."""
