"""What a terrain's children and the mesh it wears are there for: custom properties of theirs."""

import bpy

ROLE = "orogen_role"
INSTEAD_OF = "orogen_instead_of"  # of a mesh: name of the one for which it stands in


def with_role(terrain, role):
    return [child for child in terrain.children if child.get(ROLE) == role]


def own_mesh(terrain):
    """The terrain's mesh, also while another one stands in for it."""
    return bpy.data.meshes.get(terrain.data.get(INSTEAD_OF, ""), terrain.data)
