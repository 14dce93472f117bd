"""Work in a thread of its own, which the main thread asks how far it is."""
import threading


class BackgroundTask:
    """Calls `work(progress)`; `progress(stage, fraction)` returns False once the task is cancelled. `on_end` is called in the thread of
    the work when all is done."""

    def __init__(self, work, on_end=lambda: None):
        self._work = work
        self._on_end = on_end
        self._is_cancelled = False
        self.progress = ("", 0.0)
        self.result = None
        self.error = None
        self.is_running = True
        # The interpreter waits for it at its end: a thread that outlives Python ends in a crash.
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    @property
    def is_cancelled(self):
        return self._is_cancelled

    def cancel(self):
        """Ends the work at its next word of progress; whoever does not want to wait drops the task."""
        self._is_cancelled = True

    def wait(self):
        self._thread.join()

    def _run(self):
        try:
            self.result = self._work(self._on_progress)
        except Exception as error:  # told by the main thread
            self.error = error
        self.is_running = False
        self._on_end()

    def _on_progress(self, stage, fraction):
        self.progress = (stage, fraction)
        return not self._is_cancelled
