"""The source banks of takes: session, layers, plug-ins and recipe."""
