"""Geometry-node groups that ship: made by code when they are wanted, then the file's own."""
