"""Growth as it was watched last, until another is watched: what an animation can be made of.

Its frames are coarse; they are drawn on the terrain's grid, and the detail of the finished terrain
comes in by and by, in proportion to the years.
"""

import numpy as np

MOST = 240  # frames that are held: beyond, every other one goes


class WatchedGrowth:
    def __init__(self):
        self.uid = None  # of the terrain
        self.mark = None  # fingerprint of what it was grown from
        self._years, self._heights = [], []

    def begin(self, uid):
        self.__init__()
        self.uid = uid

    def add(self, frame):
        """Takes over a Result with the heights. Water that wears grown mountains counts from the
        beginning again: that is no growth."""
        if self._years and frame.years < self.years:
            return
        self._years.append(frame.years)
        self._heights.append(np.array(frame.fields["elevation"]))
        if len(self._years) > MOST:
            del self._years[1::2], self._heights[1::2]

    @property
    def years(self):
        """When it was seen last."""
        return self._years[-1]

    def is_of(self, uid, mark):
        return len(self._years) > 1 and (self.uid, self.mark) == (uid, mark)

    def frames(self, count, end, still):
        """`count` pairs of years and heights in even steps, the last one being the terrain `still`
        at the years `end`."""
        last = on_grid(self._heights[-1], still.shape)
        detail = still - last
        years = np.array(self._years)
        for i in range(1, count):
            now = end * i / count
            k = int(np.clip(np.searchsorted(years, now), 1, len(years) - 1))
            share = np.clip((now - years[k - 1]) / (years[k] - years[k - 1]), 0.0, 1.0)
            a, b = self._heights[k - 1], self._heights[k]
            ground = on_grid(a + np.float32(share) * (b - a), still.shape)
            yield now, ground + np.float32(now / end) * detail
        yield end, still


def on_grid(coarse, shape):
    """Heights on a finer grid over the same rectangle, bilinear."""
    scale = max(coarse.shape) / max(shape)  # cells of the coarse grid, to one of the fine
    rows, row_share = _places(coarse.shape[0], shape[0], scale)
    columns, column_share = _places(coarse.shape[1], shape[1], scale)
    lines = coarse[rows] + row_share[:, None] * (coarse[rows + 1] - coarse[rows])
    return lines[:, columns] + column_share * (lines[:, columns + 1] - lines[:, columns])


def _places(coarse, fine, scale):
    """Of each fine cell: the coarse one before its centre, and the share of the way to the next."""
    place = np.clip((np.arange(fine) + 0.5) * scale - 0.5, 0.0, coarse - 1.0)
    first = np.minimum(place.astype(int), coarse - 2)
    return first, (place - first).astype(np.float32)


watched_growth = WatchedGrowth()
