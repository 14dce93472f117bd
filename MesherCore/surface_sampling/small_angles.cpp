#include "surface_sampling/small_angles.h"

#include "brep/curve_cuts.h"
#include "surface_sampling/apex_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace mesher {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
// Corners of boxes have angles of 90 degrees up to rounding, which are not small.
constexpr double kAngleSlack = 1e-6;
// Shells are made that much smaller, as exponents of two, before an apex is left unprotected.
constexpr int kShellTries = 12;
// A ring around a tip has six sides or so: it is the smaller the more segments are wanted on a turn.
constexpr double kUsualPerTurn = 12.0;
// Radius of a ring as a share of the edges that end in the tip, and in units of the largest sag: that of its sides is an
// eighth of the radius at the most.
constexpr double kRingOfEdge = 0.25, kRingOfSag = 7.0;

/// The edges of one face that meet in its tip.
struct EdgesAtTip
{
    std::vector<BrepEdgeId> edges;
    double facetAngle = 0.0;  ///< degrees
};

/// The last segment of an edge at a vertex.
struct EdgeEnd
{
    SegmentId segment;
    CurveEnd end = CurveEnd::First;
    Vec3 direction;  ///< away from the vertex, of length 1
};

}  // namespace

class SmallAngleProtection
{
public:
    SmallAngleProtection(CurveChains& chains, IdVector<NodeId, MeshNode>& nodes,
                         const CurveChainOptions& options)
        : chains_(chains), model_(*chains.model_), nodes_(nodes), options_(options)
    {
    }

    void run()
    {
        std::vector<std::vector<EdgeEnd>> endsOf(model_.vertices.size());
        for (std::uint32_t e = 0; e < model_.edges.size(); ++e) collectEnds(BrepEdgeId(e), endsOf);
        findTips();
        for (std::uint32_t v = 0; v < endsOf.size(); ++v) findComplexes(BrepVertexId(v), endsOf[v]);
        enrolments_.resize(chains_.segments_.size());
        splitBetweenApexes();
        cutAtShells();
    }

private:
    struct Enrolment
    {
        AngleComplexId first;
        AngleComplexId last;

        [[nodiscard]] AngleComplexId only() const { return first.isValid() ? first : last; }
    };

    void findTips()
    {
        tipsOf_.resize(model_.vertices.size());
        for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
            for (const FaceApex& apex : apexesOf(model_, BrepFaceId(f)))
                tipsOf_[apex.vertex].push_back(
                    {edgesAt(model_, BrepFaceId(f), apex.vertex), apex.facetAngle});
        }
    }

    void collectEnds(BrepEdgeId id, std::vector<std::vector<EdgeEnd>>& endsOf) const
    {
        const std::vector<SegmentId> chain = chains_.chainOf(id);
        if (chain.empty()) return;
        const BrepEdge& edge = model_.edges[id];
        endsOf[edge.first.value].push_back(
            {chain.front(), CurveEnd::First, directionAt(id, CurveEnd::First)});
        endsOf[edge.last.value].push_back({chain.back(), CurveEnd::Last, directionAt(id, CurveEnd::Last)});
    }

    /// The tangent into the edge, or the direction of a short chord where the derivative vanishes.
    [[nodiscard]] Vec3 directionAt(BrepEdgeId id, CurveEnd end) const
    {
        constexpr double kShortChord = 1e-3, kSmallSpeed = 1e-6;
        const BrepEdge& edge = model_.edges[id];
        const TangentVariation& table = *chains_.variations_[id];
        const bool isFirst = end == CurveEnd::First;
        const double t = isFirst ? edge.part.first : edge.part.last;
        Vec3 direction = (isFirst ? 1.0 : -1.0) * edge.curve->evaluate(t).d1;
        if (!(length(direction) * edge.part.length() > kSmallSpeed * table.totalLength())) {
            const double share = isFirst ? kShortChord : 1.0 - kShortChord;
            const double inside = table.parameterAtLengthFraction(edge.part.first, edge.part.last, share);
            direction = edge.curve->position(inside) - edge.curve->position(t);
        }
        const double size = length(direction);
        return size > 0.0 ? 1.0 / size * direction : Vec3{};
    }

    static double angleBetween(const EdgeEnd& a, const EdgeEnd& b)
    {
        return std::atan2(length(cross(a.direction, b.direction)), dot(a.direction, b.direction)) *
               kDegreesPerRadian;
    }

    /// Groups the ends that pairs of small angles connect.
    void findComplexes(BrepVertexId apex, const std::vector<EdgeEnd>& ends)
    {
        std::vector<std::size_t> group(ends.size());
        for (std::size_t i = 0; i < ends.size(); ++i) group[i] = i;
        std::vector<double> smallest(ends.size(), CurveChains::kSmallAngleLimit);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const double angle = angleBetween(ends[i], ends[j]);
                if (!(angle < CurveChains::kSmallAngleLimit - kAngleSlack)) continue;
                const std::size_t low = std::min(group[i], group[j]), high = std::max(group[i], group[j]);
                smallest[low] = std::min({smallest[low], smallest[high], angle});
                std::replace(group.begin(), group.end(), high, low);
            }
        }
        for (const EdgesAtTip& tip : tipsOf_[apex]) joinAtTip(tip, ends, group, smallest);
        for (std::size_t leader = 0; leader < ends.size(); ++leader) {
            if (smallest[leader] >= CurveChains::kSmallAngleLimit || group[leader] != leader) continue;
            const AngleComplexId complex = chains_.smallAngles_.push_back(
                {apex, {}, smallest[leader], 0, hasAllTips(apex, ends, group, leader)});
            for (std::size_t i = leader; i < ends.size(); ++i) {
                if (group[i] == leader) enrol(ends[i], complex);
            }
        }
    }

    /// The ends at the tip of a face are one group.
    void joinAtTip(const EdgesAtTip& tip, const std::vector<EdgeEnd>& ends, std::vector<std::size_t>& group,
                   std::vector<double>& smallest) const
    {
        std::optional<std::size_t> leader;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const BrepEdgeId edge = chains_.segments_[ends[i].segment].edge;
            if (!std::binary_search(tip.edges.begin(), tip.edges.end(), edge)) continue;
            const std::size_t low = std::min(group[i], leader.value_or(group[i]));
            const std::size_t high = std::max(group[i], leader.value_or(group[i]));
            smallest[low] = std::min({smallest[low], smallest[high], tip.facetAngle});
            std::replace(group.begin(), group.end(), high, low);
            leader = low;
        }
    }

    /// One shell for all tips of a vertex: else those of one would not be those of the other. Edges that go elsewhere do not count.
    [[nodiscard]] bool hasAllTips(BrepVertexId apex, const std::vector<EdgeEnd>& ends,
                                  const std::vector<std::size_t>& group, std::size_t leader) const
    {
        const std::vector<EdgesAtTip>& tips = tipsOf_[apex];
        const auto isAtTip = [&](BrepEdgeId edge) {
            return std::any_of(tips.begin(), tips.end(), [&](const EdgesAtTip& tip) {
                return std::binary_search(tip.edges.begin(), tip.edges.end(), edge);
            });
        };
        bool isAny = false;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (!isAtTip(chains_.segments_[ends[i].segment].edge)) continue;
            if (group[i] != leader) return false;
            isAny = true;
        }
        return isAny;
    }

    void enrol(const EdgeEnd& end, AngleComplexId complex)
    {
        chains_.smallAngles_[complex].edges.push_back(chains_.segments_[end.segment].edge);
        enrolments_.resize(chains_.segments_.size());
        Enrolment& enrolment = enrolments_[end.segment];
        (end.end == CurveEnd::First ? enrolment.first : enrolment.last) = complex;
    }

    /// A segment between two apexes is split at its ordinary place; either half then has one.
    void splitBetweenApexes()
    {
        const std::size_t count = enrolments_.size();
        for (std::uint32_t i = 0; i < count; ++i) {
            const Enrolment whole = enrolments_[SegmentId(i)];
            if (!whole.first.isValid() || !whole.last.isValid()) continue;
            const auto halves = chains_.split(SegmentId(i), nodes_);
            enrolments_.resize(chains_.segments_.size());
            enrolments_[SegmentId(i)] = {};
            if (!halves) {
                chains_.unprotected_ += 2;
                continue;
            }
            enrolments_[halves->halves[0]].first = whole.first;
            enrolments_[halves->halves[1]].last = whole.last;
        }
    }

    [[nodiscard]] double chordOf(SegmentId s) const
    {
        const SurfaceSegment& segment = chains_.segments_[s];
        return length(nodes_[segment.node[1]].position - nodes_[segment.node[0]].position);
    }

    void cutAtShells()
    {
        IdVector<AngleComplexId, std::vector<SegmentId>> members(chains_.smallAngles_.size());
        for (std::uint32_t i = 0; i < enrolments_.size(); ++i) {
            const AngleComplexId complex = enrolments_[SegmentId(i)].only();
            if (complex.isValid()) members[complex].push_back(SegmentId(i));
        }
        for (std::uint32_t i = 0; i < members.size(); ++i)
            cutAtShell(AngleComplexId(i), members[AngleComplexId(i)]);
    }

    [[nodiscard]] CurveEnd nearEndOf(SegmentId s) const
    {
        return enrolments_[s].first.isValid() ? CurveEnd::First : CurveEnd::Last;
    }

    [[nodiscard]] double largestRingOf(const SmallAngleAtVertex& complex) const
    {
        double largest = std::numeric_limits<double>::infinity();
        for (const BrepEdgeId edge : complex.edges)
            largest = std::min(largest, kRingOfEdge * chains_.variations_[edge]->totalLength());
        if (options_.segmentsPerTurn > kUsualPerTurn) largest *= kUsualPerTurn / options_.segmentsPerTurn;
        if (options_.maxSag > 0.0) largest = std::min(largest, kRingOfSag * options_.maxSag);
        return largest;
    }

    /// The largest shell that all members reach with growing distance; members that reach none stay as they are.
    void cutAtShell(AngleComplexId id, const std::vector<SegmentId>& members)
    {
        double shortest = std::numeric_limits<double>::infinity();
        for (const SegmentId s : members) shortest = std::min(shortest, chordOf(s));
        SmallAngleAtVertex& complex = chains_.smallAngles_[id];
        if (!(shortest > 0.0)) {
            chains_.unprotected_ += members.size();
            complex.isAroundTip = false;
            return;
        }
        if (complex.isAroundTip) shortest = std::min(shortest, largestRingOf(complex));
        const int largest = firstShellExponent(shortest);
        int exponent = largest;
        const auto reaches = [&](SegmentId s) {
            return chains_.shellPlace(s, nearEndOf(s), id, std::ldexp(1.0, exponent)).has_value();
        };
        while (exponent > largest - kShellTries && !std::all_of(members.begin(), members.end(), reaches))
            --exponent;
        const bool isReached = exponent > largest - kShellTries;
        if (!isReached) exponent = largest;
        complex.firstShell = exponent;
        complex.isAroundTip = complex.isAroundTip && isReached && members.size() == complex.edges.size();
        for (const SegmentId s : members) cutMember(id, s, std::ldexp(1.0, exponent));
    }

    void cutMember(AngleComplexId id, SegmentId s, double radius)
    {
        const CurveEnd end = nearEndOf(s);
        const auto place = chains_.shellPlace(s, end, id, radius);
        if (!place) {
            ++chains_.unprotected_;
            return;
        }
        CurveChains::Record& record = chains_.records_[s];
        record.complex = id;
        record.nearEnd = end;
        record.nearRadius = 0.0;
        const SegmentSplit halves = chains_.split(s, *place, nodes_);
        // Beyond the first shell the curves go their own ways.
        chains_.records_[halves.halves[end == CurveEnd::First ? 1 : 0]].complex = AngleComplexId();
    }

    CurveChains& chains_;
    const BrepModel& model_;
    IdVector<NodeId, MeshNode>& nodes_;
    const CurveChainOptions& options_;
    IdVector<BrepVertexId, std::vector<EdgesAtTip>> tipsOf_;
    IdVector<SegmentId, Enrolment> enrolments_;
};

void protectSmallAngles(CurveChains& chains, IdVector<NodeId, MeshNode>& nodes,
                        const CurveChainOptions& options)
{
    SmallAngleProtection(chains, nodes, options).run();
}

}  // namespace mesher
