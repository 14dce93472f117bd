"""Whether a mesh is that of its shape still."""
import hashlib
import re

# Of a shape in a BREP text: free, modified, checked and so on. They change by looking at the shape.
_FLAGS = re.compile(r"^[01]{7}$", re.MULTILINE)


def hash_of(shape):
    """Of what it is, and where; not of how it is displayed. The text has fifteen digits, as a document that is saved."""
    text = _FLAGS.sub("", shape.copy(True, False).exportBrepToString())
    return hashlib.sha256(text.encode()).hexdigest()[:16]
