"""Writing terrains into meshes: positions, named attributes, the sea."""
