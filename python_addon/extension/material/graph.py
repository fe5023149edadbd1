"""Shader nodes written as expressions: every method makes a node and returns its output."""


class Graph:
    def __init__(self, tree):
        self.tree = tree
        tree.nodes.clear()

    def node(self, kind, *inputs, **settings):
        """A node with settings; inputs are sockets or values, in order; None leaves one alone."""
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        for socket, value in zip(node.inputs, inputs, strict=False):
            self.connect(socket, value)
        return node

    def connect(self, socket, value):
        if value is None:
            return
        if hasattr(value, "is_linked"):
            self.tree.links.new(value, socket)
        elif socket.type == "RGBA" and len(value) == 3:
            socket.default_value = (*value, 1.0)
        else:
            socket.default_value = value

    def math(self, operation, *inputs):
        return self.node("ShaderNodeMath", *inputs, operation=operation).outputs[0]

    def attribute(self, name, of="GEOMETRY"):
        node = self.node("ShaderNodeAttribute", attribute_name=name, attribute_type=of)
        return node.outputs["Fac"]

    def color(self, name):
        """The colour that an attribute of the geometry holds."""
        node = self.node("ShaderNodeAttribute", attribute_name=name, attribute_type="GEOMETRY")
        return node.outputs["Color"]

    def scaled(self, color, factor):
        """A colour made brighter or darker."""
        node = self.node("ShaderNodeVectorMath", color, operation="SCALE")
        self.connect(node.inputs["Scale"], factor)
        return node.outputs[0]

    def smooth(self, value, start, end):
        """0 below `start`, 1 above `end`, smoothly between; falling if `start` is above `end`."""
        rising = self._values(start) <= self._values(end)
        low, high, to = (start, end, (0.0, 1.0)) if rising else (end, start, (1.0, 0.0))
        node = self.node(
            "ShaderNodeMapRange", value, low, high, *to, interpolation_type="SMOOTHSTEP"
        )
        return node.outputs[0]

    @staticmethod
    def _values(value):
        return value.default_value if hasattr(value, "is_linked") else value

    def mix(self, factor, first, second):
        """From the first colour to the second."""
        node = self.node("ShaderNodeMix", data_type="RGBA")
        colours = [socket for socket in node.inputs if socket.type == "RGBA"]
        self.connect(node.inputs[0], factor)
        self.connect(colours[0], first)
        self.connect(colours[1], second)
        return next(socket for socket in node.outputs if socket.type == "RGBA")

    def ramp(self, value, low, high, stops, interpolation="LINEAR"):
        """A colour from stops (value, colour) between `low` and `high`."""
        position = self.node("ShaderNodeMapRange", value, low, high).outputs[0]
        node = self.node("ShaderNodeValToRGB", position)
        node.color_ramp.interpolation = interpolation
        elements = node.color_ramp.elements
        while len(elements) > 1:
            elements.remove(elements[-1])
        for i, (at, colour) in enumerate(stops):
            element = elements[0] if i == 0 else elements.new((at - low) / (high - low))
            element.position = (at - low) / (high - low)
            element.color = (*colour, 1.0)
        return node.outputs[0]

    def noise(self, position, scale, detail, roughness=0.55):
        """Fractal noise, about 0.5 +- 0.2. `scale` is in periods a unit."""
        node = self.node("ShaderNodeTexNoise")
        self.connect(node.inputs["Vector"], position)
        for name, value in (("Scale", scale), ("Detail", detail), ("Roughness", roughness)):
            self.connect(node.inputs[name], value)
        return node.outputs[0]

    def arrange(self, step=190):
        """Lays the nodes out by their distance from the output."""
        depth = dict.fromkeys(self.tree.nodes, 0)
        for _ in range(len(depth)):
            changed = False
            for link in self.tree.links:
                wanted = depth[link.to_node] + 1
                if depth[link.from_node] < wanted:
                    depth[link.from_node], changed = wanted, True
            if not changed:
                break
        rows = {}
        for node, column in depth.items():
            rows[column] = rows.get(column, -1) + 1
            node.location = (-step * column, -220 * rows[column])
