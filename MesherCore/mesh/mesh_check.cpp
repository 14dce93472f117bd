#include "mesh/mesh_check.h"

#include "mesh/mesh_check_steps.h"

#include <string_view>
#include <utility>

namespace mesher {

namespace {

constexpr double kLargestVolumeGap = 1e-9;

}  // namespace

MeshCheckReport checkMesh(const ClassifiedMesh& mesh)
{
    RunContext context;
    return checkMesh(mesh, context);
}

MeshCheckReport checkMesh(const ClassifiedMesh& mesh, RunContext& context)
{
    MeshCheckReport report;
    report.counts = {mesh.nodes.size(), mesh.points.size(), mesh.lines.size(), mesh.triangles.size(),
                     mesh.tets.size()};
    if (!detail::checkReferences(mesh, report)) return report;
    for (const auto check :
         {detail::checkNodes, detail::checkClassification, detail::checkSurface, detail::checkVolume}) {
        if (context.mayGoOn()) check(mesh, report);
    }
    return report;
}

std::vector<std::string> MeshCheckReport::problems() const
{
    const std::pair<std::uint64_t, std::string_view> defects[] = {
        {badReferences, "elements with missing or repeated nodes"},
        {nonFiniteNodes, "nodes with coordinates that are not finite or absurdly large"},
        {duplicateNodes, "nodes at the place of another node"},
        {orphanNodes, "nodes in no element"},
        {duplicateElements, "elements that are there twice"},
        {unclassified, "nodes or elements without an entity of the model"},
        {misclassified, "elements on an entity that does not fit them or their nodes"},
        {linesNotEdges, "lines that are not edges of a triangle"},
        {trianglesNotFaces, "triangles that are not faces of a tetrahedron"},
        {boundaryWithoutElement, "sides of the boundary without a boundary element"},
        {interfaceWithoutElement, "sides between two entities without an element"},
        {inverted, "inverted elements"},
        {degenerate, "flat elements"},
        {overSharedSides, "sides that more than two elements share"},
        {foldedSides, "sides with both neighbours on the same side"},
        {openBoundaryEdges, "edges at which the boundary is not closed"},
        {inwardTriangles, "boundary triangles that look inward"},
    };
    std::vector<std::string> problems;
    if (counts.triangles + counts.tets == 0) problems.emplace_back("no triangles and no tetrahedra");
    for (const auto& [count, what] : defects) {
        if (count != 0) problems.push_back(std::to_string(count) + " " + std::string(what));
    }
    if (!(volumeGap < kLargestVolumeGap)) {
        problems.emplace_back("the boundary does not enclose the volume of the tetrahedra");
    }
    return problems;
}

}  // namespace mesher
