"""Fields of a terrain as colours on its ground."""
