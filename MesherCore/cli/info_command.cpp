#include "brep/occt/read_model.h"
#include "cli/commands.h"
#include "pipeline/planar_area.h"

#include <iomanip>
#include <map>

namespace mesher {

namespace {

std::string_view nameOf(SurfaceKind kind)
{
    switch (kind) {
        case SurfaceKind::Plane: return "plane";
        case SurfaceKind::Cylinder: return "cylinder";
        case SurfaceKind::Cone: return "cone";
        case SurfaceKind::Sphere: return "sphere";
        case SurfaceKind::Torus: return "torus";
        case SurfaceKind::Bezier: return "Bezier";
        case SurfaceKind::BSpline: return "B-spline";
        case SurfaceKind::Extrusion: return "extrusion";
        case SurfaceKind::Revolution: return "revolution";
        case SurfaceKind::Offset: return "offset";
        case SurfaceKind::Other: return "other";
    }
    return "other";
}

/// The largest tolerance and the entity that has it.
template <class IdType, class Entities>
void printTolerance(const Entities& entities, const char* what, std::ostream& out)
{
    double largest = 0.0;
    IdType where;
    for (std::uint32_t i = 0; i < entities.size(); ++i) {
        if (entities[IdType(i)].tolerance < largest) continue;
        largest = entities[IdType(i)].tolerance;
        where = IdType(i);
    }
    if (where.isValid()) out << "largest tolerance of " << what << ": " << largest << " at " << nameOf(where) << '\n';
}

void printShortestEdge(const BrepModel& model, std::ostream& out)
{
    double shortest = 0.0;
    BrepEdgeId where;
    for (std::uint32_t i = 0; i < model.edges.size(); ++i) {
        if (model.edges[BrepEdgeId(i)].isDegenerate) continue;
        const double length = edgeLength(model.edges[BrepEdgeId(i)]);
        if (where.isValid() && length >= shortest) continue;
        shortest = length;
        where = BrepEdgeId(i);
    }
    if (where.isValid()) out << "shortest edge: " << shortest << " at " << nameOf(where) << '\n';
}

}  // namespace

ExitStatus runInfo(const InfoCommand& command, Console console)
{
    const Result<ReadModel> read = readModel(command.model);
    if (!read) return tell(read.error(), ExitStatus::Failed, console);
    const BrepModel& model = read.value().model;
    const Vec3 extent = model.box.extent();
    std::ostream& out = console.out;
    out << std::setprecision(9) << "format: " << read.value().format << ", unit: " << model.unit
        << "\nsize: " << extent.x << " x " << extent.y << " x " << extent.z << "\nsolids: " << model.solids.size()
        << "\nfaces: " << model.faces.size() << "\nedges: " << model.edges.size()
        << "\nvertices: " << model.vertices.size() << '\n';
    std::map<std::string_view, std::size_t> kinds;
    for (const BrepFace& face : model.faces) ++kinds[nameOf(face.surface->kind())];
    for (const auto& [kind, count] : kinds) out << "faces of kind " << kind << ": " << count << '\n';
    printTolerance<BrepVertexId>(model.vertices, "a vertex", out);
    printTolerance<BrepEdgeId>(model.edges, "an edge", out);
    printTolerance<BrepFaceId>(model.faces, "a face", out);
    printShortestEdge(model, out);
    for (const std::string& note : model.notes) out << "note: " << note << '\n';
    return ExitStatus::Done;
}

}  // namespace mesher
