#include "quality/quality_statistics.h"

#include <algorithm>

namespace mesher {

void RangeStatistics::add(double value)
{
    least_ = count_ == 0 ? value : std::min(least_, value);
    largest_ = count_ == 0 ? value : std::max(largest_, value);
    sum_ += value;
    ++count_;
}

void addAngle(AngleHistogram& histogram, double degrees)
{
    const int bin = std::clamp(static_cast<int>(degrees / 10.0), 0, static_cast<int>(histogram.size()) - 1);
    ++histogram[static_cast<std::size_t>(bin)];
}

TriangleCorners cornersOf(const ClassifiedMesh& mesh, const MeshElement<3>& triangle)
{
    const auto& n = triangle.node;
    return {mesh.nodes[n[0]].position, mesh.nodes[n[1]].position, mesh.nodes[n[2]].position};
}

TetCorners cornersOf(const ClassifiedMesh& mesh, const MeshElement<4>& tet)
{
    const auto& n = tet.node;
    return {mesh.nodes[n[0]].position, mesh.nodes[n[1]].position, mesh.nodes[n[2]].position,
            mesh.nodes[n[3]].position};
}

TriangleQuality triangleQualityOf(const ClassifiedMesh& mesh)
{
    TriangleQuality quality;
    double smallestAngle = 360.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleShape shape = shapeOf(cornersOf(mesh, mesh.triangles[i]));
        for (const double angle : shape.angle) {
            quality.angle.add(angle);
            addAngle(quality.angleHistogram, angle);
        }
        quality.radiusRatio.add(shape.radiusRatio);
        quality.area.add(shape.area);
        quality.shortestEdge =
            i == 0 ? shape.shortestEdge : std::min(quality.shortestEdge, shape.shortestEdge);
        quality.longestEdge = std::max(quality.longestEdge, shape.longestEdge);
        if (shape.minAngle < smallestAngle) {
            smallestAngle = shape.minAngle;
            quality.worst = i;
        }
    }
    return quality;
}

TetQuality tetQualityOf(const ClassifiedMesh& mesh)
{
    TetQuality quality;
    double smallestAngle = 360.0;
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
        const TetCorners corners = cornersOf(mesh, mesh.tets[i]);
        for (const double angle : dihedralAngles(corners)) {
            quality.dihedral.add(angle);
            addAngle(quality.dihedralHistogram, angle);
            if (angle < smallestAngle) {
                smallestAngle = angle;
                quality.worst = i;
            }
        }
        quality.radiusRatio.add(score(TetMeasure::RadiusRatio, corners));
        quality.volumeRatio.add(score(TetMeasure::VolumeLength, corners));
        quality.volume.add(sixfoldVolume(corners) / 6.0);
    }
    return quality;
}

}  // namespace mesher
