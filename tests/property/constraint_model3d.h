#pragma once

#include "delaunay/triangulation3d.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace mesher::test {

/// The constrained faces and edges of a triangulation by their vertices, kept without looking at the mesh.
struct ConstraintModel3d
{
    using Face = std::array<VertexId, 3>;
    using Edge = std::array<VertexId, 2>;

    std::set<Face> faces;
    std::set<Edge> edges;

    friend bool operator==(const ConstraintModel3d&, const ConstraintModel3d&) = default;

    static Face sorted(Face face)
    {
        std::sort(face.begin(), face.end());
        return face;
    }
    static Edge sorted(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

    [[nodiscard]] bool hasFace(VertexId a, VertexId b, VertexId c) const
    {
        return faces.count(sorted({a, b, c})) > 0;
    }
    [[nodiscard]] bool hasEdge(VertexId a, VertexId b) const { return edges.count(sorted(a, b)) > 0; }

    /// The third vertices of the faces at an edge.
    [[nodiscard]] std::vector<VertexId> facesAt(VertexId a, VertexId b) const
    {
        std::vector<VertexId> apexes;
        for (const Face& face : faces) {
            const bool hasA = std::count(face.begin(), face.end(), a) > 0;
            const bool hasB = std::count(face.begin(), face.end(), b) > 0;
            if (!hasA || !hasB) continue;
            apexes.push_back(
                *std::find_if(face.begin(), face.end(), [&](VertexId v) { return v != a && v != b; }));
        }
        return apexes;
    }
    [[nodiscard]] bool isUsed(VertexId vertex) const
    {
        const auto has = [&](const auto& simplex) {
            return std::find(simplex.begin(), simplex.end(), vertex) != simplex.end();
        };
        return std::any_of(faces.begin(), faces.end(), has) || std::any_of(edges.begin(), edges.end(), has);
    }

    void splitFace(const Face& face, VertexId point)
    {
        if (faces.erase(sorted(face)) == 0) return;
        for (unsigned k = 0; k < 3; ++k) faces.insert(sorted({face[k], face[(k + 1) % 3], point}));
    }
    void splitEdge(VertexId a, VertexId b, VertexId point)
    {
        for (const VertexId apex : facesAt(a, b)) {
            faces.erase(sorted({a, b, apex}));
            faces.insert(sorted({a, point, apex}));
            faces.insert(sorted({b, point, apex}));
        }
        if (edges.erase(sorted(a, b)) == 0) return;
        edges.insert(sorted(a, point));
        edges.insert(sorted(b, point));
    }
    /// The pair of faces at (a, b) becomes the pair at the other diagonal; nothing if there is no pair.
    void flipPair(VertexId a, VertexId b)
    {
        const std::vector<VertexId> apexes = facesAt(a, b);
        if (apexes.size() != 2) return;
        for (const VertexId apex : apexes) faces.erase(sorted({a, b, apex}));
        faces.insert(sorted({apexes[0], apexes[1], a}));
        faces.insert(sorted({apexes[0], apexes[1], b}));
    }

    /// What the flags of the mesh say.
    static ConstraintModel3d of(const Triangulation3d& mesh)
    {
        ConstraintModel3d model;
        for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
            const TetId tet(i);
            if (!mesh.isAlive(tet)) continue;
            for (int face = 0; face < 4; ++face) {
                if (mesh.isFaceConstrained({tet, face}))
                    model.faces.insert(sorted(mesh.faceVertices({tet, face})));
            }
            for (int edge = 0; edge < 6; ++edge) {
                if (!mesh.isEdgeConstrained(tet, edge)) continue;
                model.edges.insert(
                    sorted(mesh.vertex(tet, kEdgeSlots[edge][0]), mesh.vertex(tet, kEdgeSlots[edge][1])));
            }
        }
        return model;
    }
};

}  // namespace mesher::test
