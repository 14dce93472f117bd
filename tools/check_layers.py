#!/usr/bin/python3
"""Holds the includes of the source to the layers that CMake declares.

The architecture is written down once: MesherCore/CMakeLists.txt lists the layers from the lowest up, and
mesher_layer(NAME … USES …), or mesher_python_module, in each folder names the lower layers it may include. This script refuses
  - a USES that names itself, a higher or an unknown layer, and a folder of sources that is no layer;
  - an include of a layer that is not in USES, of tests, or not written from MesherCore;
  - an include of an adapter (ADAPTERS) by its own layer or by any layer that is not one of its users;
  - a foreign header in MesherCore, unless FOREIGN_HEADERS allows it there;
  - a header of a GPL library outside of the programs that time peers, and the core inside of those.

    check_layers.py [ROOT]     exit 0 nothing found, 1 findings on stdout, 2 wrong usage
"""
import re
import sys
from pathlib import Path

# Headers from outside the project, by folder of MesherCore; elsewhere the standard library only.
FOREIGN_HEADERS = {
    "bindings": re.compile(r"pybind11/.+\.h"),
    "base": re.compile(r"sys/mman\.h"),
    "triangulation2d": re.compile(r"boost/geometry/.+\.hpp"),
    "brep/occt": re.compile(r".+\.hxx|dlfcn\.h|fcntl\.h|sys/wait\.h|unistd\.h"),
    "cli": re.compile(r"boost/program_options\.hpp|fcntl\.h|unistd\.h|sys/(mman|prctl|wait)\.h"),
    "io": re.compile(r"fcntl\.h|poll\.h|sys/stat\.h|unistd\.h|zlib\.h"),
    "pipeline": re.compile(r"nlohmann/json\.hpp"),
}
# Folders that hang off their layer: the layers beside themselves that may include them. A layer does not know its adapters, so
# that it can be built and tested without what they adapt.
ADAPTERS = {"brep/occt": {"bindings", "cli"}}
STANDARD_HEADER = re.compile(r"[a-z_0-9]+")
INTRINSICS_HEADER = re.compile(r"[a-z]*intrin\.h")

PEER_FOLDER = "tests/benchmarks/compare"
GPL_HEADER = re.compile(r"tetgen\.h|gmsh\.h|CGAL/(Delaunay_|Constrained_|Regular_|Triangulation|Mesh|make_mesh|refine_mesh).*")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
LAYER_CALL = re.compile(r"mesher_(?:layer|python_module)\s*\(([^)]*)\)")
SUBDIRECTORY_CALL = re.compile(r"add_subdirectory\s*\(\s*([^\s)]+)")
SOURCE_SUFFIXES = {".h", ".cpp"}


def without_cmake_comments(text):
    return re.sub(r"#.*", "", text)


def read_cmake(path):
    return without_cmake_comments(path.read_text(encoding="utf-8")) if path.is_file() else ""


def read_layers(core):
    """The layers from the lowest up, as {folder: layers it uses}, and what is wrong with the declarations."""
    findings = []
    layers = {}
    for folder in SUBDIRECTORY_CALL.findall(read_cmake(core / "CMakeLists.txt")):
        calls = LAYER_CALL.findall(read_cmake(core / folder / "CMakeLists.txt"))
        if not calls:
            continue
        words = calls[0].split()
        if len(calls) > 1 or words[0] != folder:
            findings.append(f"MesherCore/{folder}/CMakeLists.txt: declares not exactly the layer '{folder}'")
        uses = words[words.index("USES") + 1:] if "USES" in words else []
        for used in uses:
            if used not in layers:
                findings.append(f"MesherCore/{folder}/CMakeLists.txt: '{folder}' may not use '{used}': "
                                "it is not a layer below")
        layers[folder] = uses
    return layers, findings


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in SOURCE_SUFFIXES) if folder.is_dir() else []


def includes(path):
    """(line, name, is it in quotes) of each include."""
    text = path.read_text(encoding="utf-8")
    for match in INCLUDE.finditer(text):
        line = text.count("\n", 0, match.start(0)) + 1
        yield line, match.group(1) or match.group(2), match.group(1) is not None


def is_in(folder, adapter):
    return folder == adapter or folder.startswith(adapter + "/")


def find_own_include(core, layers, including_folder, name):
    layer = including_folder.split("/")[0]
    folder = name.split("/")[0]
    if "/" not in name or name.startswith("."):
        return f'"{name}" is not written from MesherCore'
    if folder not in layers:
        return f'"{name}" is in no layer of MesherCore'
    if folder != layer and folder not in layers[layer]:
        return f"'{layer}' does not declare that it uses '{folder}' (\"{name}\")"
    for adapter, users in ADAPTERS.items():
        if is_in(name, adapter) and not is_in(including_folder, adapter) and layer not in users:
            return f"'{including_folder}' may not include the adapter '{adapter}' (\"{name}\")"
    if not (core / name).is_file():
        return f'"{name}" does not exist'
    return None


def find_foreign_include(folder, name):
    if STANDARD_HEADER.fullmatch(name) or INTRINSICS_HEADER.fullmatch(name):
        return None
    for allowed_in, pattern in FOREIGN_HEADERS.items():
        if is_in(folder, allowed_in) and pattern.fullmatch(name):
            return None
    return f"<{name}> is not of the standard library and not allowed in '{folder}'"


def check_core(root):
    core = root / "MesherCore"
    layers, findings = read_layers(core)
    for path in sources(core):
        folder = path.parent.relative_to(core).as_posix()
        layer = folder.split("/")[0]
        where = path.relative_to(root).as_posix()
        if layer not in layers:
            findings.append(f"{where}: '{layer}' is not declared as a layer")
            continue
        for line, name, is_quoted in includes(path):
            finding = (find_own_include(core, layers, folder, name) if is_quoted
                       else find_foreign_include(folder, name))
            if finding:
                findings.append(f"{where}:{line}: {finding}")
    return findings


def check_licences(root):
    findings = []
    layer_names = {path.name for path in (root / "MesherCore").iterdir() if path.is_dir()}
    for path in sources(root / "tests") + sources(root / "examples"):
        where = path.relative_to(root).as_posix()
        included = list(includes(path))
        gpl = [(line, name) for line, name, _ in included if GPL_HEADER.fullmatch(name)]
        if not gpl:
            continue
        if not where.startswith(PEER_FOLDER + "/"):
            findings += [f"{where}:{line}: <{name}> belongs to a GPL library; only {PEER_FOLDER} may include it"
                         for line, name in gpl]
        findings += [f'{where}:{line}: a program that includes a GPL library may not include the core ("{name}")'
                     for line, name, is_quoted in included if is_quoted and name.split("/")[0] in layer_names]
    return findings


def main(arguments):
    if len(arguments) > 1:
        print(__doc__, file=sys.stderr)
        return 2
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    findings = check_core(root) + check_licences(root)
    for finding in findings:
        print(finding)
    if not findings:
        print(f"layers: {len(sources(root / 'MesherCore'))} files of MesherCore keep to the layers")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
