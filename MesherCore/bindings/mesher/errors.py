"""What the mesher raises. Each exception carries `failures`: dictionaries with entity, point, reason and remedy."""
import re


class MesherError(Exception):
    """The base of all others."""

    def __init__(self, message, failures=(), report=None, mesh=None):
        super().__init__(_in_words_of_python(message))
        self.failures = [{key: _in_words_of_python(value) for key, value in failure.items()} for failure in failures]
        self.report = report
        self.mesh = mesh


class ModelError(MesherError):
    """A model that cannot be read or is none."""


class MeshingError(MesherError):
    """A model that could not be meshed, or not as a whole: `mesh` is then what there is of it, or None."""


class OptionError(MesherError, ValueError):
    """An option with a value that makes no sense."""


class MesherWarning(UserWarning):
    """What the mesher noticed in a model or a mesh that was made all the same; the report lists it too."""


class Cancelled(MesherError):
    """The progress callback ended the run."""


class WriteError(MesherError):
    """A file that cannot be written, or a format that does not exist or cannot hold the mesh."""


def error_of(report, partial):
    """The exception that tells of a run that failed."""
    failures = report["failures"]
    kind = OptionError if failures and failures[0]["entity"].startswith("--") else MeshingError
    return kind("\n".join(_sentence(failure) for failure in failures), failures, report, partial)


def _sentence(failure):
    parts = [f"{failure['entity']}: {failure['reason']}" if failure["entity"] else failure["reason"]]
    if failure["remedy"]:
        parts.append(failure["remedy"])
    return "; ".join(parts) + "."


def _in_words_of_python(text):
    """The core names options as the command line does: --min-size is min_size here, --dimension 2 is dimension=2."""
    if not isinstance(text, str):
        return text
    text = text.replace("--local-size", "--local-sizes")
    text = re.sub(r"--([a-z][a-z-]*) (\d[\d.]*)\b", lambda option: f"{_name(option[1])}={option[2]}", text)
    return re.sub(r"--([a-z][a-z-]*)", lambda option: _name(option[1]), text)


def _name(option):
    return option.replace("-", "_")
