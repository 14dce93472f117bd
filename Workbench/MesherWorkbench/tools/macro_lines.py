"""What people do in the workbench, as the lines of Python that do it: a macro that is recorded meanwhile does the same again."""
import FreeCADGui


def expression_of(obj):
    return f"App.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"


def do(function, *arguments, **options):
    """Calls a function of the workbench by a line that is recorded; arguments are expressions, options are values."""
    FreeCADGui.addModule("MesherWorkbench")
    words = [*arguments, *(f"{name}={value!r}" for name, value in options.items())]
    FreeCADGui.doCommand(f"MesherWorkbench.{function}({', '.join(words)})")


def assign(obj, name, value):
    """Lengths have their unit, whatever that of the user is."""
    words = repr(f"{value.Value!r} mm" if hasattr(value, "UserString") else value)
    FreeCADGui.doCommand(f"{expression_of(obj)}.{name} = {words}")


def bind(obj, path, expression):
    FreeCADGui.doCommand(f"{expression_of(obj)}.setExpression({path!r}, {expression!r})")


def places(obj, places):
    """Where the parts of a mesh object are seen."""
    tops = ", ".join(expression_of(place.top) for place in places)
    FreeCADGui.doCommand(f"{expression_of(obj)}.Containers = [{tops}]")
    assign(obj, "ContainerPaths", [place.path for place in places])
