"""Plants in Blender: meshes of species, pictures of them for afar, and points where they stand."""
