"""The brief of a project: what a sound designer must know before work starts."""
