"""What the mesher raises. Each exception carries `failures`: dictionaries with entity, point, reason and remedy."""


class MesherError(Exception):
    """The base of all others."""

    def __init__(self, message, failures=(), report=None, mesh=None):
        super().__init__(message)
        self.failures = list(failures)
        self.report = report
        self.mesh = mesh


class ModelError(MesherError):
    """A model that cannot be read or is none."""


class MeshingError(MesherError):
    """A model that could not be meshed, or not as a whole: `mesh` is then what there is of it, or None."""


class Cancelled(MesherError):
    """The progress callback ended the run."""


class WriteError(MesherError):
    """A file that cannot be written, or a format that does not exist or cannot hold the mesh."""
