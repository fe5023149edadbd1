"""Which job a worker runs, which waits, and what was asked of them."""

import threading


class Jobs:
    """The latest job wins. Shared by the thread that works and the one that listens."""

    def __init__(self):
        self._changed = threading.Condition()
        self._waiting = None
        self._running = None  # number of the running job
        self._cancelled = False
        self._paused = False
        self._closed = False

    def put(self, request):
        """Takes a new job; returns the number of a waiting one that it replaces, or None."""
        with self._changed:
            replaced = self._waiting["job"] if self._waiting else None
            self._waiting = request
            self._cancelled = self._running is not None
            self._changed.notify()
            return replaced

    def cancel(self, number):
        """Cancels a job; returns True if it had not started, so that no one else answers it."""
        with self._changed:
            if self._waiting and self._waiting["job"] == number:
                self._waiting = None
                return True
            self._cancelled = self._cancelled or self._running == number
            self._changed.notify()
            return False

    def pause(self, number, paused):
        """Lets the running job rest where it next may, or go on."""
        with self._changed:
            self._paused = paused and self._running == number
            self._changed.notify()

    def rest(self):
        """Called by the running job: waits while it is paused."""
        with self._changed:
            self._changed.wait_for(lambda: not self._paused or self._cancelled)

    def close(self):
        with self._changed:
            self._closed = self._cancelled = True
            self._changed.notify()

    def take(self):
        """Waits for the next job; None when there will be no more."""
        with self._changed:
            self._running, self._paused = None, False
            self._changed.wait_for(lambda: self._waiting or self._closed)
            if self._closed:
                return None
            request, self._waiting = self._waiting, None
            self._running = request["job"]
            self._cancelled = False
            return request

    @property
    def cancelled(self):
        return self._cancelled
