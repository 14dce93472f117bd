#include "triangulation2d/boundary_enrichment.h"

#include "triangulation2d/boundary_intersection.h"
#include "triangulation2d/encroachment2d.h"
#include "triangulation2d/visibility2d.h"

#include <deque>
#include <optional>

namespace mesher {
namespace {

class Enrichment
{
public:
    Enrichment(const PlanarDomain& domain, Boundary& boundary, Budget& budget)
        : domain_(domain),
          boundary_(boundary),
          budget_(budget),
          index_(boundary),
          visibility_(domain, boundary, index_)
    {
    }

    Result<BoundaryEnrichment2d> run()
    {
        for (;;) {
            // A split may open a line of sight that was blocked when its vertex had its turn: all get another one.
            const std::size_t splitsBefore = result_.splits;
            for (std::uint32_t i = 0; i < boundary_.vertices.size(); ++i)
                queue_.push_back(BoundaryVertexId(i));
            ++result_.rounds;
            emptyQueue();
            if (error_) return *error_;
            if (isExhausted_) return result_;
            if (result_.splits != splitsBefore) continue;
            const auto pairs = findIntersections(boundary_, index_);
            if (pairs.empty()) return result_;
            for (const auto& [first, second] : pairs) {
                for (const SubcurveId s : {first, second}) {
                    if (!boundary_.subcurves[s].isAlive) continue;
                    if (split(s)) ++result_.intersectionSplits;
                }
                if (error_ && boundary_.subcurves[first].isAlive && boundary_.subcurves[second].isAlive) {
                    return meetingError(first, second);
                }
                error_.reset();
            }
        }
    }

private:
    void emptyQueue()
    {
        std::vector<SubcurveId> found;
        while (!queue_.empty() && !error_ && !isExhausted_) {
            const BoundaryVertexId v = queue_.front();
            queue_.pop_front();
            Box2 box;
            box.include(boundary_.position(v));
            index_.query(box, found);
            for (const SubcurveId s : found) {
                if (boundary_.subcurves[s].isAlive && isEncroached(s, v) && split(s)) queue_.push_back(v);
                if (error_ || isExhausted_) break;
            }
        }
    }

    [[nodiscard]] bool isEncroached(SubcurveId s, BoundaryVertexId v)
    {
        const Subcurve& subcurve = boundary_.subcurves[s];
        if (subcurve.first == v || subcurve.last == v) return false;
        return isInDiametralCircle(boundary_.from(s), boundary_.to(s), boundary_.position(v)) &&
               visibility_.isVisible(v, s);
    }

    bool split(SubcurveId s)
    {
        if (!budget_.allows({boundary_.vertices.size(), 0})) {
            isExhausted_ = true;
            return false;
        }
        const auto place = splitPlace(domain_, boundary_, s);
        if (!place) {
            error_ = shortError(s);
            return false;
        }
        index_.remove(boundary_, s);
        const Boundary::Halves halves = boundary_.split(s, *place);
        index_.insert(boundary_, halves.first);
        index_.insert(boundary_, halves.last);
        queue_.push_back(halves.vertex);
        ++result_.splits;
        return true;
    }

    [[nodiscard]] Error shortError(SubcurveId s) const
    {
        const Subcurve& subcurve = boundary_.subcurves[s];
        Error error;
        error.code = ErrorCode::IntersectingConstraints;
        error.entity = domain_.nameOf(subcurve.curve);
        error.message = "the curve meets another one, or itself, away from a common point";
        error.point = boundary_.vertices[subcurve.first].space;
        error.remedy = "split the curves where they meet";
        return error;
    }

    [[nodiscard]] Error meetingError(SubcurveId a, SubcurveId b) const
    {
        Error error = shortError(a);
        error.entity += " and " + domain_.nameOf(boundary_.subcurves[b].curve);
        return error;
    }

    const PlanarDomain& domain_;
    Boundary& boundary_;
    Budget& budget_;
    BoundaryIndex index_;
    Visibility2d visibility_;
    std::deque<BoundaryVertexId> queue_;
    BoundaryEnrichment2d result_;
    std::optional<Error> error_;
    bool isExhausted_ = false;
};

}  // namespace

Result<BoundaryEnrichment2d> enrichBoundary(const PlanarDomain& domain, Boundary& boundary, Budget& budget)
{
    return Enrichment(domain, boundary, budget).run();
}

}  // namespace mesher
