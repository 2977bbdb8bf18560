"""References: pictures, sounds, clips, texts and links that show what is meant, pinned to what they are for."""
