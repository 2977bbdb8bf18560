"""The distance of takes from approved sounds."""
