"""Read-only screens that join rooms: Today, the desk, the project page, find."""
