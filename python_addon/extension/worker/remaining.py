"""How long a job will go on, from how it went on so far."""

import math

MEMORY = 6.0  # s: what is older by as much counts for 1/e
PATIENCE = 1.0  # s of history before anything is said
STEP = 0.2  # s between what is kept


def note(history, now, fraction):
    """The history with where the job stands now: pairs of time (s) and fraction done. What counts
    for nothing any more is left out."""
    if history and now - history[-1][0] < STEP:
        return history
    return [(t, f) for t, f in history if now - t < 5 * MEMORY] + [(now, fraction)]


def seconds_left(history):
    """None where too little is known. Speed is a mean in which the past fades."""
    if len(history) < 2 or history[-1][0] - history[0][0] < PATIENCE:
        return None
    end, done = history[-1]
    spent = made = 0.0
    for (t0, f0), (t1, f1) in zip(history, history[1:], strict=False):
        weight = math.exp((0.5 * (t0 + t1) - end) / MEMORY)
        spent += weight * (t1 - t0)
        made += weight * (f1 - f0)
    return (1.0 - done) * spent / made if made > 0.0 else None


def in_words(seconds):
    """In steps that do not flicker; nothing where nothing is known."""
    if seconds is None:
        return ""
    if seconds < 60:
        step = 1 if seconds < 10 else 5
        return f"about {max(1, step * round(seconds / step))} s left"
    if seconds < 3600:
        return f"about {round(seconds / 60)} min left"
    return f"about {seconds / 3600:.1f} h left"
