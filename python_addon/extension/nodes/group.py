"""Making a group of geometry nodes, and a child of a terrain that wears it."""

import bpy

from ..material.graph import Graph
from ..mesh import children

TERRAIN = "Terrain"  # the first input of every group


class Group(Graph):
    def __init__(self, tree):
        super().__init__(tree)
        self._inputs = tree.nodes.new("NodeGroupInput")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")

    def input(self, name, kind, default=None, **limits):
        """Declares an input (kind: "Float", "Object" ...) and returns its socket."""
        socket = self.tree.interface.new_socket(
            name, in_out="INPUT", socket_type=f"NodeSocket{kind}"
        )
        if default is not None:
            socket.default_value = default
        for limit, value in limits.items():
            setattr(socket, limit, value)
        return self._inputs.outputs[name]

    def geometry_of(self, object_socket, as_instance=False):
        node = self.node("GeometryNodeObjectInfo", object_socket, transform_space="RELATIVE")
        node.inputs["As Instance"].default_value = as_instance
        return node.outputs["Geometry"]

    def field(self, name):
        """A named attribute of numbers; `name` is a string or a socket."""
        node = self.node("GeometryNodeInputNamedAttribute", name, data_type="FLOAT")
        return node.outputs[0]

    def stored(self, geometry, name, value):
        """The geometry with a named attribute of numbers."""
        node = self.node("GeometryNodeStoreNamedAttribute", geometry, data_type="FLOAT")
        self.connect(node.inputs["Name"], name)
        values = [socket for socket in node.inputs if socket.name == "Value" and socket.enabled]
        self.connect(values[0], value)
        return node.outputs[0]

    def up(self, kind):
        """The upward part of "Normal" or "Position"."""
        vector = self.node(f"GeometryNodeInput{kind}").outputs[0]
        return self.node("ShaderNodeSeparateXYZ", vector).outputs["Z"]

    def random(self, low, high, seed):
        node = self.node("FunctionNodeRandomValue", data_type="FLOAT")
        numbers = [socket for socket in node.inputs if socket.type == "VALUE"]
        self.connect(numbers[0], low)
        self.connect(numbers[1], high)
        self.connect(node.inputs["Seed"], seed)
        return next(socket for socket in node.outputs if socket.type == "VALUE")

    def finish(self, geometry):
        self.node("NodeGroupOutput", geometry)
        self.arrange()


def ensure(name, build):
    """The group of that name, built if the file has none."""
    tree = bpy.data.node_groups.get(name)
    if tree is None or tree.library or tree.bl_idname != "GeometryNodeTree":
        tree = bpy.data.node_groups.new(name, "GeometryNodeTree")
        tree.is_modifier = True
        build(Group(tree))
    return tree


def add_child(terrain, role, tree, **inputs):
    """A child of the terrain whose geometry the group makes from it. `inputs` by name."""
    ob = children.add(terrain, role, role, bpy.data.meshes.new)
    modifier = ob.modifiers.new(tree.name, "NODES")
    modifier.node_group = tree
    for name, value in {TERRAIN: terrain, **inputs}.items():
        set_input(modifier, name, value)
    return ob


def set_input(modifier, name, value):
    socket = next(
        item
        for item in modifier.node_group.interface.items_tree
        if item.item_type == "SOCKET" and item.in_out == "INPUT" and item.name == name
    )
    if hasattr(modifier, "properties"):  # Blender 5.2
        getattr(modifier.properties.inputs, socket.identifier).value = value
    else:
        modifier[socket.identifier] = value
