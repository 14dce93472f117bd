"""Update mesh: the selected mesh made again, of its shape as it is now."""
import FreeCAD
import FreeCADGui

from ..messages import show_refusal, translated
from ..objects.mesh import is_mesh_object


class _UpdateCommand:
    def GetResources(self):
        return {"MenuText": "Update mesh", "ToolTip": "Mesh the shape of the selected mesh again, with the same sizes",
                "Pixmap": "MesherUpdateMesh", "Accel": "M, U"}

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        selection = FreeCADGui.Selection.getSelection()
        if FreeCADGui.Control.activeDialog():
            show_refusal(translated("Another task is open. Finish it first."))
        elif len(selection) != 1 or not is_mesh_object(selection[0]):
            show_refusal(translated("Select one mesh of this workbench first."))
        else:
            selection[0].ViewObject.Proxy.update()


COMMANDS = (("Mesher_UpdateMesh", _UpdateCommand()),)
