#include "solid_verdict.h"

#include "brep/model_inspection.h"
#include "kernel_triangles.h"
#include "mesh/classified_mesh_hash.h"
#include "mesh/mesh_check.h"
#include "pipeline/model_check.h"
#include "quality/quality_statistics.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>

namespace mesher::test {

namespace {

/// The kernel's quadrature is good to about this, relative, on most shapes; where a mesh departs by more it is asked again for
/// the finer one, which takes long and divides faces until it does not change.
constexpr double kQuadrature = 2e-3;
constexpr double kFineQuadrature = 1e-5;
/// Lines may cut off the sharp end of a curve that is nearly straight where it is measured.
constexpr double kShortLength = 0.03;
/// A flat or straight element departs from what it stands for by less than this share of its longest edge.
constexpr double kLargestSag = 0.4;

struct Facet
{
    std::array<Vec3, 3> corner;
    [[nodiscard]] Vec3 areaVector() const
    {
        return 0.5 * cross(corner[1] - corner[0], corner[2] - corner[0]);
    }
    [[nodiscard]] Vec3 centre() const { return (1.0 / 3.0) * (corner[0] + corner[1] + corner[2]); }
    [[nodiscard]] double longestEdge() const
    {
        return std::max(
            {length(corner[1] - corner[0]), length(corner[2] - corner[1]), length(corner[0] - corner[2])});
    }
};

/// What the facets of a face, or the lines of an edge, add up to.
struct Sum
{
    double measure = 0.0;  ///< area or length
    double departure =
        0.0;  ///< measure times distance from the geometry: bounds the volume or area in between
    double shrinkage = 0.0;  ///< by how much the measure may fall short because the geometry is curved
};

std::string told(const std::string& entity, const char* what, double found, double wanted)
{
    std::ostringstream text;
    text.precision(10);
    text << entity << ' ' << what << ' ' << found << " instead of " << wanted;
    return text.str();
}

/// Compares a mesh with a shape, stopping at the first thing that is wrong.
class Comparison
{
public:
    Comparison(const BrepModel& model, const TopoDS_Shape& shape, const ClassifiedMesh& mesh)
        : model_(model),
          shape_(shape),
          mesh_(mesh),
          tolerance_(inspectModel(model).largestTolerance.value),
          faces_(model.faces.size()),
          edges_(model.edges.size())
    {
    }

    [[nodiscard]] std::optional<std::string> problem()
    {
        if (auto found = measureFacets()) return found;
        if (auto found = measureLines()) return found;
        if (auto found = compareEdges()) return found;
        if (auto found = compareFaces()) return found;
        return compareSolids();
    }

private:
    /// Every point of the surface bounds the distance; a search without a seed may miss the nearest one.
    [[nodiscard]] double distanceFrom(const Surface& surface, const Vec3& place,
                                      const MeshElement<3>& triangle) const
    {
        double distance = surface.project(place).distance;
        for (const NodeId id : triangle.node) {
            const MeshNode& node = mesh_.nodes[id];
            if (distance > tolerance_ && node.entity == triangle.entity)
                distance = std::min(distance, surface.project(place, node.parameters).distance);
        }
        return distance;
    }

    /// How far the flat facet is from its face, at its centre and in the middle of its edges.
    [[nodiscard]] double departureOf(const Facet& facet, const Surface& surface,
                                     const MeshElement<3>& triangle) const
    {
        const auto& [a, b, c] = facet.corner;
        double largest = 0.0;
        for (const Vec3& place : {facet.centre(), 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
            largest = std::max(largest, distanceFrom(surface, place, triangle));
        return largest;
    }

    /// By how much nodes on edges are beside the surface: more than the tolerance, in some shapes that the kernel calls valid.
    [[nodiscard]] double nodesOff(const MeshElement<3>& triangle, const Surface& surface) const
    {
        double largest = 0.0;
        for (const NodeId id : triangle.node) {
            const MeshNode& node = mesh_.nodes[id];
            if (node.entity.dimension < 2)
                largest = std::max(largest, surface.project(node.position).distance);
        }
        return largest;
    }

    [[nodiscard]] std::optional<std::string> measureFacets()
    {
        for (const MeshElement<3>& triangle : mesh_.triangles) {
            if (triangle.entity.index == EntityRef::kNone) continue;
            const BrepFaceId id(triangle.entity.index);
            const Facet facet = {cornersOf(mesh_, triangle)};
            const double distance = departureOf(facet, *model_.faces[id].surface, triangle);
            const double size = facet.longestEdge(), area = length(facet.areaVector());
            if (!(distance <= kLargestSag * size + tolerance_) &&
                !(distance <= kLargestSag * size + nodesOff(triangle, *model_.faces[id].surface)))
                return told(nameOf(id), "has a facet that is off by", distance, 0.0);
            Sum& sum = faces_[id];
            sum.measure += area;
            sum.departure += 1.5 * distance * area;
            sum.shrinkage += area * std::min(1.0, 12.0 * (distance / size) * (distance / size));
        }
        return std::nullopt;
    }

    /// How far the straight line is from its curve, at its quarters.
    [[nodiscard]] static double departureOf(const Vec3& a, const Vec3& b, const BrepEdge& edge)
    {
        double largest = 0.0;
        for (const double t : {0.25, 0.5, 0.75})
            largest = std::max(largest, edge.curve->project((1.0 - t) * a + t * b, edge.part).distance);
        return largest;
    }

    [[nodiscard]] std::optional<std::string> measureLines()
    {
        for (const MeshElement<2>& line : mesh_.lines) {
            if (line.entity.index == EntityRef::kNone) continue;
            const BrepEdgeId id(line.entity.index);
            const BrepEdge& edge = model_.edges[id];
            const Vec3 a = mesh_.nodes[line.node[0]].position, b = mesh_.nodes[line.node[1]].position;
            const double size = length(b - a);
            if (edge.isDegenerate) return nameOf(id) + " is a point and has a line";
            const double distance = departureOf(a, b, edge);
            if (!(distance <= kLargestSag * size + edge.tolerance))
                return told(nameOf(id), "has a line that is off by", distance, 0.0);
            Sum& sum = edges_[id];
            sum.measure += size;
            sum.departure += distance * size;
            sum.shrinkage += size * std::min(1.0, 12.0 * (distance / size) * (distance / size));
        }
        return std::nullopt;
    }

    /// Seams have no lines: they are no features of the shape.
    [[nodiscard]] std::vector<char> seams() const
    {
        std::vector<char> isSeam(model_.edges.size());
        for (const BrepFace& face : model_.faces) {
            std::vector<std::uint32_t> uses;
            for (const BrepLoop& loop : face.loops) {
                for (const BrepCoedge& coedge : loop.coedges) uses.push_back(coedge.edge.value);
            }
            std::sort(uses.begin(), uses.end());
            for (std::size_t i = 1; i < uses.size(); ++i) {
                if (uses[i] == uses[i - 1]) isSeam[uses[i]] = 1;
            }
        }
        return isSeam;
    }

    [[nodiscard]] std::optional<std::string> compareEdges() const
    {
        TopTools_IndexedMapOfShape shapes;
        TopExp::MapShapes(shape_, TopAbs_EDGE, shapes);
        const std::vector<char> isSeam = seams();
        for (std::uint32_t i = 0; i < model_.edges.size(); ++i) {
            const BrepEdgeId id(i);
            if (model_.edges[id].isDegenerate || isSeam[i] != 0) continue;
            GProp_GProps properties;
            BRepGProp::LinearProperties(shapes(static_cast<int>(i) + 1), properties);
            const double wanted = properties.Mass();
            const double slack =
                kShortLength * wanted + edges_[id].shrinkage + 4.0 * model_.edges[id].tolerance;
            if (!(std::abs(edges_[id].measure - wanted) <= slack))
                return told(nameOf(id), "has the length", edges_[id].measure, wanted);
        }
        return std::nullopt;
    }

    /// What the chords of a face's edges cut off or add, in its area.
    [[nodiscard]] double slackOfLoops(const BrepFace& face) const
    {
        double slack = 0.0;
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                const Sum& sum = edges_[coedge.edge];
                slack += sum.departure + sum.measure * model_.edges[coedge.edge].tolerance;
            }
        }
        return slack;
    }

    [[nodiscard]] std::optional<std::string> compareFaces()
    {
        TopTools_IndexedMapOfShape shapes;
        TopExp::MapShapes(shape_, TopAbs_FACE, shapes);
        for (std::uint32_t i = 0; i < model_.faces.size(); ++i) {
            const BrepFaceId id(i);
            const TopoDS_Shape& shape = shapes(static_cast<int>(i) + 1);
            // However narrow it is: the slack of its edges may be more than its area.
            if (!(faces_[id].measure > 0.0)) return nameOf(id) + " has no facets";
            const double slack =
                kQuadrature * faces_[id].measure + faces_[id].shrinkage + slackOfLoops(model_.faces[id]);
            const double found = faces_[id].measure;
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(shape, properties);
            if (!(std::abs(found - properties.Mass()) <= slack)) {
                properties = GProp_GProps();
                BRepGProp::SurfaceProperties(shape, properties, kFineQuadrature);
            }
            double wanted = properties.Mass();
            if (!(std::abs(found - wanted) <= slack)) wanted = areaOfTriangulation(TopoDS::Face(shape));
            if (!(std::abs(found - wanted) <= slack)) return told(nameOf(id), "has the area", found, wanted);
            areaOfFace_.push_back(wanted);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::string> compareSolids() const
    {
        TopTools_IndexedMapOfShape shapes;
        TopExp::MapShapes(shape_, TopAbs_SOLID, shapes);
        std::vector<double> volume(model_.solids.size());
        for (const MeshElement<4>& tet : mesh_.tets) {
            const TetCorners p = cornersOf(mesh_, tet);
            volume[tet.entity.index] += dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])) / 6.0;
        }
        for (std::uint32_t i = 0; i < model_.solids.size(); ++i) {
            double slack = kQuadrature * volume[i];
            for (const BrepShell& shell : model_.solids[BrepSolidId(i)].shells) {
                for (const BrepShellFace& use : shell.faces) {
                    const BrepFace& face = model_.faces[use.face];
                    slack += faces_[use.face].departure + areaOfFace_[use.face.value] * face.tolerance;
                    slack += slackOfLoops(face) * longestLine(face);
                }
            }
            const TopoDS_Shape& shape = shapes(static_cast<int>(i) + 1);
            GProp_GProps properties;
            BRepGProp::VolumeProperties(shape, properties);
            if (!(std::abs(volume[i] - std::abs(properties.Mass())) <= slack)) {
                properties = GProp_GProps();
                BRepGProp::VolumeProperties(shape, properties, kFineQuadrature);
            }
            const double wanted = std::abs(properties.Mass());
            if (!(std::abs(volume[i] - wanted) <= slack))
                return told(nameOf(BrepSolidId(i)), "has the volume", volume[i], wanted);
        }
        return std::nullopt;
    }

    /// How far chords lead off their curve, over the loops of a face.
    [[nodiscard]] double longestLine(const BrepFace& face) const
    {
        double longest = 0.0;
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                const Sum& sum = edges_[coedge.edge];
                if (sum.measure > 0.0) longest = std::max(longest, sum.departure / sum.measure);
            }
        }
        return longest;
    }

    const BrepModel& model_;
    const TopoDS_Shape& shape_;
    const ClassifiedMesh& mesh_;
    double tolerance_;  ///< the largest of the model
    IdVector<BrepFaceId, Sum> faces_;
    IdVector<BrepEdgeId, Sum> edges_;
    std::vector<double> areaOfFace_;
};

/// Errors of files say the file before the entity: "part.step, Face3".
std::optional<EntityRef> entityOf(const Error& error)
{
    const std::size_t blank = error.entity.rfind(' ');
    return entityNamed(blank == std::string::npos ? error.entity : error.entity.substr(blank + 1));
}

/// Of the report, by what the mesh itself says.
std::optional<std::string> problemOfReport(const MeshReport& report, const ClassifiedMesh& mesh)
{
    const TetQuality quality = tetQualityOf(mesh);
    if (!report.tetQuality) return "the report has no quality";
    if (std::abs(report.tetQuality->dihedral.least() - quality.dihedral.least()) > 1e-6)
        return "the report's smallest dihedral angle is not the mesh's";
    if (report.meshHash != classifiedMeshHash(mesh)) return "the report's hash is not the mesh's";
    return std::nullopt;
}

bool isInModel(EntityRef entity, const BrepModel& model)
{
    const std::array<std::size_t, 4> counts = {model.vertices.size(), model.edges.size(), model.faces.size(),
                                               model.solids.size()};
    return entity.index < counts[entity.dimension];
}

/// A use of an edge by a face, seen from inside of the solid on one side of it.
struct EdgeUse
{
    BrepCoedge coedge;
    const BrepFace* face = nullptr;
    bool isReversed = false;  ///< the solid lies on the side of the surface's normal
};

/// The direction from the edge into the face, and the face's normal out of the solid; nothing where either has none.
struct Wing
{
    Vec3 inward;
    Vec3 outward;
};

std::optional<Wing> wingOf(const EdgeUse& use, const BrepEdge& edge, double share)
{
    const double t = edge.part.first + share * (edge.part.last - edge.part.first);
    const SurfacePoint point = use.face->surface->evaluate(use.coedge.parameterCurve->position(t));
    const Vec3 along = (use.coedge.isReversed ? -1.0 : 1.0) * edge.curve->evaluate(t).d1;
    const Vec3 inward = cross(point.normal(), along);
    if (!(length(inward) > 0.0) || !(length(point.normal()) > 0.0)) return std::nullopt;
    return Wing{(1.0 / length(inward)) * inward,
                ((use.isReversed ? -1.0 : 1.0) / length(point.normal())) * point.normal()};
}

/// Degrees inside the solid between two faces at their edge; 180 where they leave more than that.
double angleBetween(const EdgeUse& a, const EdgeUse& b, const BrepEdge& edge)
{
    double least = 180.0;
    for (const double share : {0.02, 0.25, 0.5, 0.75, 0.98}) {
        const std::optional<Wing> first = wingOf(a, edge, share), second = wingOf(b, edge, share);
        if (!first || !second || dot(second->inward, first->outward) > 0.0) continue;
        const double cosine = std::clamp(dot(first->inward, second->inward), -1.0, 1.0);
        least = std::min(least, std::acos(cosine) * 180.0 / std::numbers::pi);
    }
    return least;
}

/// The smallest angle between faces, degrees, over all edges of all solids.
double smallestFaceAngle(const BrepModel& model)
{
    double least = 180.0;
    for (const BrepSolid& solid : model.solids) {
        IdVector<BrepEdgeId, std::vector<EdgeUse>> uses(model.edges.size());
        for (const BrepShell& shell : solid.shells) {
            for (const BrepShellFace& part : shell.faces) {
                const BrepFace& face = model.faces[part.face];
                for (const BrepLoop& loop : face.loops) {
                    for (const BrepCoedge& coedge : loop.coedges)
                        uses[coedge.edge].push_back({coedge, &face, part.isReversed});
                }
            }
        }
        for (std::uint32_t e = 0; e < model.edges.size(); ++e) {
            const BrepEdge& edge = model.edges[BrepEdgeId(e)];
            const std::vector<EdgeUse>& around = uses[BrepEdgeId(e)];
            if (edge.isDegenerate || around.size() != 2) continue;
            least = std::min(least, angleBetween(around[0], around[1], edge));
        }
    }
    return least;
}

/// Degrees between faces, and between edges of a face.
struct ModelAngles
{
    double faces = 180.0;
    double edges = 180.0;
};

ModelAngles anglesOf(const BrepModel& model)
{
    const ModelFacts facts = inspectModel(model);
    return {smallestFaceAngle(model), facts.smallestAngle ? facts.smallestAngle->degrees : 180.0};
}

std::string figuresOf(const ClassifiedMesh& mesh, const ModelAngles& angles)
{
    const TetQuality quality = tetQualityOf(mesh);
    std::ostringstream text;
    text.precision(4);
    text << mesh.tets.size() << " tets, " << quality.dihedral.least() << " to " << quality.dihedral.largest()
         << " at";
    for (const NodeId node : mesh.tets[quality.worst].node) text << ' ' << nameOf(mesh.nodes[node].entity);
    text << "; of the model " << angles.faces << ' ' << angles.edges;
    return text.str();
}

/// No mesh can have larger angles than the shape; but a flat tetrahedron is not the shape's fault.
std::optional<std::string> problemOfQuality(const ClassifiedMesh& mesh, const ModelAngles& angles)
{
    constexpr double kSharp = 1.0, kFlat = 0.01;
    const double least = tetQualityOf(mesh).dihedral.least();
    if (least >= kFlat || std::min(angles.faces, angles.edges) < kSharp) return std::nullopt;
    return told("mesh", "has a flat tetrahedron with the angle", least,
                std::min(angles.faces, angles.edges)) +
           ": " + figuresOf(mesh, angles);
}

}  // namespace

SolidVerdict judgeError(const Error& error)
{
    using Kind = SolidVerdict::Kind;
    const bool isClear = entityOf(error) && !error.message.empty() && !error.remedy.empty() &&
                         (!error.point || isFinite(*error.point));
    return {isClear ? Kind::Refused : Kind::Failed, (isClear ? "" : "not clear: ") + describe(error)};
}

SolidVerdict judge(const BrepModel& model, const TopoDS_Shape& shape, const MeshOutcome& outcome)
{
    using Kind = SolidVerdict::Kind;
    const MeshReport& report = outcome.report;
    if (report.stopReason != StopReason::Done)
        return {Kind::Failed, "stopped: " + std::string(nameOf(report.stopReason))};
    if (!report.failures.empty()) {
        const Error& error = report.failures.front();
        const std::optional<EntityRef> entity = entityOf(error);
        if (entity && !isInModel(*entity, model)) return {Kind::Failed, "no such entity: " + describe(error)};
        return judgeError(error);
    }
    if (report.status != MeshReport::Status::Done || !outcome.mesh)
        return {Kind::Failed, "no mesh, no reason"};
    const MeshCheckReport check = checkMesh(*outcome.mesh);
    if (!check.isValid()) return {Kind::Failed, "mesh_check: " + check.problems().front()};
    const ModelCheckReport onModel = checkAgainstModel(*outcome.mesh, model);
    if (!onModel.isValid())
        return {Kind::Failed, told("model_check: " + onModel.problems().front(), "; on faces",
                                   onModel.largestDistance[2], 0.0) +
                                  " at " + onModel.farthestEntity[2] +
                                  told(", on edges", "", onModel.largestDistance[1], 0.0) + " at " +
                                  onModel.farthestEntity[1]};
    if (const auto problem = Comparison(model, shape, *outcome.mesh).problem())
        return {Kind::Failed, *problem};
    if (const auto problem = problemOfReport(report, *outcome.mesh)) return {Kind::Failed, *problem};
    const ModelAngles angles = anglesOf(model);
    if (const auto problem = problemOfQuality(*outcome.mesh, angles)) return {Kind::Failed, *problem};
    return {Kind::Valid, figuresOf(*outcome.mesh, angles)};
}

}  // namespace mesher::test
