"""When which preview grows. No bpy here, and no clock: the time is told.

One preview grows at a time. What changes meanwhile waits, and only its newest state grows then. A
preview that takes long is given up for a newer one; but the one that follows may end, so that
something is seen however long a drag lasts.
"""

PATIENCE = 0.3  # s


class Turns:
    def __init__(self):
        self.growing = None
        self._waiting = {}  # terrains in the order in which they were noticed
        self._since = 0.0
        self._overtook = False

    @property
    def idle(self):
        return self.growing is None and not self._waiting

    def notice(self, terrain):
        """Something of a terrain may have changed."""
        self._waiting[terrain] = None

    def due(self, now):
        """The terrain to look at now, or None."""
        if self.growing is None:
            return next(iter(self._waiting), None)
        late = now - self._since > PATIENCE and not self._overtook
        return self.growing if late and self.growing in self._waiting else None

    def drop(self, terrain):
        """It need not grow."""
        self._waiting.pop(terrain, None)

    def start(self, terrain, now):
        self.drop(terrain)
        self._overtook = self.growing is not None
        self.growing, self._since = terrain, now

    def end(self):
        self.growing, self._overtook = None, False
