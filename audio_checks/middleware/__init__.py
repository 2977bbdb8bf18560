"""Projects of middleware and engines: which sound files a game plays, and at which gain.

Text files alone are read: of Wwise, FMOD Studio, Unity and Godot, and for Unreal a JSON file that a script in the
editor writes. `read_project` chooses the reader. All of it comes from strangers: size, depth and number are bounded,
and a file that cannot be read is named in `Project.unread` while the rest is read.
"""
