"""File → Export: the selected meshes in the formats of this workbench, which hold what solvers of finite volumes and others read."""
import os

import FreeCAD

import mesher
from mesher.fem_mesh import of_fem_mesh

from .messages import show_refusal, translated

# One for each in the list of kinds of files; the format is that of the extension.
FILE_TYPES = ("Gmsh 4.1 with physical groups (*.msh)", "SU2 with markers (*.su2)", "VTK with entities of cells (*.vtu)",
              "STL by faces (*.stl)", "PLY (*.ply)", "Abaqus and CalculiX with sets (*.inp)", "I-DEAS with groups (*.unv)")


def export(objects, path):
    """What FreeCAD calls: meshes of FEM and of this workbench, of which there has to be one."""
    meshes = [obj for obj in objects if obj.isDerivedFrom("Fem::FemMeshObject")]
    if len(meshes) != 1:
        show_refusal(translated("Select one mesh to export; {count} are selected.").format(count=len(meshes)))
        return
    try:
        mesh, names = of_fem_mesh(meshes[0].FemMesh)
        mesh.write(path)
    except (ValueError, mesher.MesherError) as error:
        show_refusal(translated("{label} is not exported: {reason}").format(label=meshes[0].Label, reason=error))
        return
    other = [f"{ours} is {theirs}" for ours, theirs in names.items() if ours != theirs]
    text = translated("{path}: groups are numbered, {names}").format(path=os.path.basename(path), names=", ".join(other)) if other else path
    FreeCAD.Console.PrintMessage(f"Mesher: {text}\n")
