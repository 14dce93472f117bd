#include "surface_sampling/curve_chains.h"

#include <algorithm>
#include <cmath>

namespace mesher {

std::vector<SegmentId> CurveChains::chainOf(BrepEdgeId edge) const
{
    std::vector<SegmentId> chain;
    for (SegmentId s = firstOf_[edge]; s.isValid(); s = records_[s].next) chain.push_back(s);
    return chain;
}

std::optional<SegmentPlace> CurveChains::splitPlace(SegmentId s) const
{
    MESHER_PRECONDITION(isAlive(s));
    const Record& record = records_[s];
    if (record.complex.isValid()) {
        const double radius = 0.5 * (record.nearRadius + record.farRadius);
        if (auto place = shellPlace(s, record.nearEnd, record.complex, radius)) return place;
    }
    return equalVariationPlace(s);
}

double CurveChains::floorOf(SegmentId s) const
{
    double least = floors_[segments_[s].edge];
    for (const NodeId node : segments_[s].node) {
        if (node.value < vertexFloors_.size())
            least = std::max(least, vertexFloors_[BrepVertexId(node.value)]);
    }
    return least;
}

std::optional<SegmentPlace> CurveChains::placeAt(SegmentId s, double t) const
{
    const SurfaceSegment& segment = segments_[s];
    const TangentVariation& table = *variations_[segment.edge];
    const auto [t0, t1] = segment.parameter;
    if (!(t0 < t && t < t1)) return std::nullopt;
    if (std::min(table.arcLength(t0, t), table.arcLength(t, t1)) < floorOf(s)) return std::nullopt;
    const Vec3 position = table.curve().position(t);
    if (position == table.curve().position(t0) || position == table.curve().position(t1)) return std::nullopt;
    return SegmentPlace{t, position, {}, 0.0};
}

std::optional<SegmentPlace> CurveChains::equalVariationPlace(SegmentId s) const
{
    const SurfaceSegment& segment = segments_[s];
    const auto [t0, t1] = segment.parameter;
    return placeAt(s, variations_[segment.edge]->balancedSplit(t0, t1));
}

std::optional<SegmentPlace> CurveChains::shellPlace(SegmentId s, CurveEnd nearEnd, AngleComplexId complex,
                                                    double radius) const
{
    const SurfaceSegment& segment = segments_[s];
    const TangentVariation& table = *variations_[segment.edge];
    const Interval part{segment.parameter[0], segment.parameter[1]};
    const Vec3& apex = model_->vertices[smallAngles_[complex].apex].position;
    // The end may lie off the apex by the gap between curve and vertex.
    const double t = nearEnd == CurveEnd::First ? part.first : part.last;
    if (!(length(table.curve().position(t) - apex) < radius)) return std::nullopt;
    const DistanceCrossing crossing = table.parameterAtDistance(apex, radius, part, nearEnd);
    if (!crossing.parameter || !crossing.isMonotone) return std::nullopt;
    auto place = placeAt(s, *crossing.parameter);
    if (place) place->complex = complex;
    if (place) place->radius = radius;
    return place;
}

SegmentSplit CurveChains::split(SegmentId s, const SegmentPlace& place, IdVector<NodeId, MeshNode>& nodes)
{
    MESHER_PRECONDITION(isAlive(s));
    SegmentSplit result;
    const SurfaceSegment whole = segments_[s];
    const Record record = records_[s];
    result.node = nodes.push_back({place.position, {1, whole.edge.value}, {place.parameter, 0.0}});
    if (place.complex.isValid()) {
        shells_.resize(result.node.value + 1);
        shells_[result.node] = {place.complex, place.radius};
    }
    SurfaceSegment first = whole, last = whole;
    first.node[1] = last.node[0] = result.node;
    first.parameter[1] = last.parameter[0] = place.parameter;
    Record firstRecord = record, lastRecord = record;
    const bool isFirstNear = record.nearEnd == CurveEnd::First;
    if (record.complex.isValid() && place.complex == record.complex) {
        (isFirstNear ? firstRecord : lastRecord).farRadius = place.radius;
        (isFirstNear ? lastRecord : firstRecord).nearRadius = place.radius;
    } else {
        firstRecord.complex = lastRecord.complex = AngleComplexId();
    }
    const SegmentId a = segments_.push_back(first), b = segments_.push_back(last);
    firstRecord.next = b;
    lastRecord.previous = a;
    records_.push_back(firstRecord);
    records_.push_back(lastRecord);
    if (record.previous.isValid()) {
        records_[record.previous].next = a;
    } else {
        firstOf_[whole.edge] = a;
    }
    if (record.next.isValid()) records_[record.next].previous = b;
    segments_[s].edge = BrepEdgeId();
    result.halves = {a, b};
    ++aliveCount_;
    return result;
}

std::optional<SegmentSplit> CurveChains::split(SegmentId s, IdVector<NodeId, MeshNode>& nodes)
{
    const auto place = splitPlace(s);
    if (!place) return std::nullopt;
    return split(s, *place, nodes);
}

double CurveChains::shellAround(BrepVertexId tip) const
{
    for (const SmallAngleAtVertex& complex : smallAngles_) {
        if (complex.isAroundTip && complex.apex == tip) return std::ldexp(1.0, complex.firstShell);
    }
    return 0.0;
}

bool CurveChains::isOnShellAround(BrepVertexId tip, NodeId node) const
{
    if (node.value >= shells_.size() || !shells_[node].complex.isValid()) return false;
    const SmallAngleAtVertex& complex = smallAngles_[shells_[node].complex];
    return complex.isAroundTip && complex.apex == tip &&
           shells_[node].radius == std::ldexp(1.0, complex.firstShell);
}

bool CurveChains::spansSmallAngle(NodeId a, NodeId b) const
{
    if (a.value >= shells_.size() || b.value >= shells_.size()) return false;
    const Shell &first = shells_[a], &second = shells_[b];
    return first.complex.isValid() && first.complex == second.complex && first.radius == second.radius;
}

}  // namespace mesher
