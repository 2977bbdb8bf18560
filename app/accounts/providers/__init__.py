"""Sign-in by a studio's OpenID Connect provider."""
