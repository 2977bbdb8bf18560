"""Every game file of a project rendered again."""
