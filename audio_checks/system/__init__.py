"""What the operating system asks for: paths, text files, isolated processes."""
