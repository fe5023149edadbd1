"""World coordinates and metres on a terrain's plane.

The plane is the terrain object's own x and y, heights are its z, without the exaggeration. What is
a child of a terrain lies on that terrain: so a copy of a terrain that is moved aside reads the
drawing that both share as the first does.
"""

import numpy as np


class Plane:
    def __init__(self, terrain):
        self._matrix = np.array(terrain.matrix_world)
        self._inverse = np.array(terrain.matrix_world.inverted_safe())
        across, up = terrain.orogen.local_scale()
        self._scale = np.array([across, across, up])

    def metres(self, points):
        """World points as (n, 3): metres east, north and up."""
        points = np.asarray(points, float).reshape(-1, 3)
        return (points @ self._inverse[:3, :3].T + self._inverse[:3, 3]) / self._scale

    def arrow(self, vector):
        """A vector of the world: metres east and north."""
        return (self._inverse[:2, :3] @ np.asarray(vector, float)) / self._scale[:2]

    def world(self, points, height=0.0):
        """(n, 3) in the world of places (n, 2) on the plane, or at a height above it (m)."""
        points = np.asarray(points, float).reshape(-1, 2) * self._scale[:2]
        level = self._matrix[:3, 3] + height * self._scale[2] * self._matrix[:3, 2]
        return points @ self._matrix[:3, :2].T + level

    def places(self, points):
        """(n, 3) in the world of places (n, 3): metres east, north and up."""
        points = np.asarray(points, float).reshape(-1, 3) * self._scale
        return points @ self._matrix[:3, :3].T + self._matrix[:3, 3]

    @property
    def key(self):
        """The same for the same plane."""
        return self._matrix.tobytes() + self._scale.tobytes()

    @property
    def up(self):
        """The direction of heights in the world."""
        return self._matrix[:3, 2]


def cursor_place(terrain, scene, size):
    """The 3D cursor on the terrain's plane (m); its middle if the cursor lies off a rectangle of
    that size around it."""
    place = Plane(terrain).metres(scene.cursor.location)[0, :2]
    return place if (abs(place) <= 0.5 * np.asarray(size)).all() else np.zeros(2)


class Planes:
    """The plane that each object of a drawing lies on."""

    def __init__(self, terrain):
        self._terrain = terrain
        self._known = {}

    def of(self, ob):
        while ob is not None and not ob.orogen.is_terrain:
            ob = ob.parent
        ob = ob or self._terrain
        if ob.session_uid not in self._known:
            self._known[ob.session_uid] = Plane(ob)
        return self._known[ob.session_uid]
