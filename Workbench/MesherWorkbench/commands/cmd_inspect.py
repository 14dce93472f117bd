"""Inspect mesh: cuts and worst elements of the selected mesh."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..messages import show_refusal, translated


class _InspectCommand:
    def GetResources(self):
        return {"MenuText": "Inspect mesh", "ToolTip": "Cut the selected mesh open, and find its worst elements",
                "Pixmap": "MesherInspectMesh", "Accel": "M, I"}

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        selection = FreeCADGui.Selection.getSelection()
        refusal = self._refusal(selection)
        if refusal is not None:
            show_refusal(refusal)
            return
        from ..taskpanels.task_inspection import TaskInspection

        mesh = selection[0]
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            panel = TaskInspection(mesh)
        except ValueError as others:
            show_refusal(translated("The mesh has {others}: only tetrahedra and triangles are inspected.").format(others=others))
            return
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        # What is selected has the colour of the selection, the worst element as well.
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Control.showDialog(panel)

    @staticmethod
    def _refusal(selection):
        if FreeCADGui.Control.activeDialog():
            return translated("Another task is open. Finish it first.")
        if len(selection) != 1 or not selection[0].isDerivedFrom("Fem::FemMeshObject"):
            return translated("Select one mesh of FEM or of this workbench first.")
        if not selection[0].FemMesh.FaceCount + selection[0].FemMesh.VolumeCount:
            return translated("The mesh is empty. Mesh it first.")
        return None


COMMANDS = (("Mesher_InspectMesh", _InspectCommand()),)
