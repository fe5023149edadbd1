"""Numbers beside a colour scale. No bpy here."""

import math

_STEPS = (1, 2, 2.5, 5, 10)


def ticks(low, high, logarithmic=False, most=5):
    """Round numbers from `low` to `high`, up to `most` of them."""
    if logarithmic:
        return _powers(low, high, most)
    size = 10.0 ** math.floor(math.log10((high - low) / most))
    step = next(size * s for s in _STEPS if (high - low) / (size * s) < most)
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    return [k * step for k in range(first, last + 1)]


def share(value, low, high, logarithmic=False):
    """Where a number stands between `low` (0) and `high` (1)."""
    if logarithmic:
        value, low, high = (math.log10(v) for v in (value, low, high))
    return (value - low) / (high - low)


def text(value):
    """A number as short as its ticks allow; `-0` is 0."""
    return f"{value + 0.0:.4g}" if abs(value) < 1e4 else f"{value:,.0f}".replace(",", "\u2009")


def _powers(low, high, most):
    first, last = math.ceil(math.log10(low) - 1e-6), math.floor(math.log10(high) + 1e-6)
    powers = [10.0**k for k in range(first, last + 1)]
    if len(powers) < 2:
        return [low, high]
    return powers[:: -(-len(powers) // most)]
