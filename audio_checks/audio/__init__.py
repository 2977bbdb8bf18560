"""One sound file: opened, decoded, hashed and measured, in a confined child where that is needed."""
