"""The text of a contract: the library of clauses, templates, figures and named terms."""
