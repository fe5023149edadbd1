"""When which preview grows. No bpy here, and no clock: the time is told.

One preview grows at a time. What changes meanwhile waits, and only its newest state grows then. A
preview that takes much longer than the one before is given up for a newer one; but the one that
follows may end, so that something is seen however long a drag lasts.
"""

PATIENCE = 0.3  # s, at least
TIMES = 2.5  # what counts as much longer


class Turns:
    def __init__(self):
        self.growing = None
        self._waiting = {}  # terrains in the order in which they were noticed
        self._since = self._usual = 0.0
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
        late = now - self._since > max(PATIENCE, TIMES * self._usual)
        overtakes = late and not self._overtook and self.growing in self._waiting
        return self.growing if overtakes else None

    def drop(self, terrain):
        """It need not grow."""
        self._waiting.pop(terrain, None)

    def start(self, terrain, now):
        self.drop(terrain)
        self._overtook = self.growing is not None
        self.growing, self._since = terrain, now

    def end(self, now):
        self.growing, self._overtook, self._usual = None, False, now - self._since
