#include "improvement/vertex_smoothing.h"

#include "improvement/dihedral_score.h"
#include "improvement/least_direction.h"
#include "predicates/orient3d.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mesher {

namespace {

constexpr double kActive = 1.1;       // scores up to so many times the least take part
constexpr double kLongestStep = 0.3;  // of the shortest edge at the node
constexpr double kWantedGain = 0.8;   // of the logarithm of the squared score, in one step
constexpr double kLeastGain = 1.002;  // of the score
constexpr double kLeastDirection =
    0.02;  // gain of that logarithm over the shortest edge below which it is no way up

}  // namespace

bool VertexSmoothing::prepare(NodeId n)
{
    const MeshNode& node = complex_.node(n);
    dimension_ = node.entity.dimension;
    if (dimension_ == 0 || (dimension_ == 3) != complex_.isInside(n)) return false;
    if (dimension_ < 3 && boundary_ == BoundaryChanges::None) return false;
    if (dimension_ < 3) {
        const std::optional<Vec3> axis = dimension_ == 2 ? geometry_.normal(n) : geometry_.tangent(n);
        if (!axis) return false;
        axis_ = *axis;
    }
    best_ = {n, node.position, node.parameters, {}};
    star_.clear();
    score_ = std::numeric_limits<double>::infinity();
    double square = score_;
    for (const TetId t : complex_.star(n)) {
        const TetNodes& v = complex_.nodes(t);
        const auto slot = static_cast<std::size_t>(std::find(v.begin(), v.end(), n) - v.begin());
        star_.push_back({complex_.corners(v), slot, complex_.score(t)});
        score_ = std::min(score_, complex_.score(t));
        for (const NodeId other : v) {
            if (other != n)
                square = std::min(square, squaredLength(complex_.position(other) - node.position));
        }
    }
    shortest_ = std::sqrt(square);
    return score_ > 0.0;
}

/// The part of a vector along which the node may move.
Vec3 VertexSmoothing::within(const Vec3& v) const
{
    if (dimension_ == 3) return v;
    const Vec3 along = dot(v, axis_) * axis_;
    return dimension_ == 1 ? along : v - along;
}

Vec3 VertexSmoothing::direction()
{
    gradients_.clear();
    for (const StarTet& tet : star_) {
        if (tet.score > kActive * score_) continue;
        const ScoreGradients found = scoreGradients(tet.corners, tet.slot, kActive * score_);
        for (std::size_t i = 0; i < found.count; ++i) gradients_.push_back(within(found.gradient[i]));
    }
    return leastOfHull(gradients_);
}

bool VertexSmoothing::evaluatePlace(const Vec3& target)
{
    if (dimension_ < 3) return geometry_.evaluateMove(best_.node, target, trial_);
    trial_.node = best_.node;
    trial_.position = target;
    return true;
}

/// Least score of the star with the node there; not more than `floor` as soon as that is known. The tetrahedron that told it
/// is asked first from then on.
double VertexSmoothing::leastAt(const Vec3& position, double floor)
{
    double least = std::numeric_limits<double>::infinity();
    trialScores_.resize(star_.size());
    for (std::size_t i = 0; i < star_.size(); ++i) {
        TetCorners corners = star_[i].corners;
        corners[star_[i].slot] = position;
        trialScores_[i] = dihedralScore(corners);
        least = std::min(least, trialScores_[i]);
        if (least > floor) continue;
        std::swap(star_[0], star_[i]);
        break;
    }
    return least;
}

/// One step up, the longest of some that helps; `step` is the length to begin with, and what it came to.
bool VertexSmoothing::climb(const Vec3& along, double& step)
{
    for (int halving = 0; halving <= kHalvings; ++halving, step *= 0.5) {
        if (!evaluatePlace(best_.position + step * along)) continue;
        const double least = leastAt(trial_.position, kLeastGain * score_);
        if (least <= kLeastGain * score_) continue;
        if (dimension_ < 3 && !geometry_.allows(trial_)) continue;
        score_ = least;
        std::swap(best_, trial_);
        for (std::size_t i = 0; i < star_.size(); ++i) {
            star_[i].corners[star_[i].slot] = best_.position;
            star_[i].score = trialScores_[i];
        }
        return true;
    }
    return false;
}

/// Whether it got anywhere.
bool VertexSmoothing::climbTo(double target)
{
    bool isMoved = false;
    for (int i = 0; i < kClimbs && score_ < target; ++i) {
        const Vec3 way = direction();
        const double slope = length(way);
        if (!(slope * shortest_ > kLeastDirection)) break;
        double step = std::min(kLongestStep * shortest_, kWantedGain / slope);
        if (!climb((1.0 / slope) * way, step)) break;
        isMoved = true;
    }
    return isMoved;
}

bool VertexSmoothing::isPositive() const
{
    return std::all_of(star_.begin(), star_.end(), [](const StarTet& tet) {
        const TetCorners& p = tet.corners;
        return orient3d(p[0], p[1], p[2], p[3]) == Sign::Positive;
    });
}

bool VertexSmoothing::evaluate(NodeId n, double target)
{
    return prepare(n) && climbTo(target) && isPositive();
}

bool VertexSmoothing::evaluateNew(std::span<const FacetNodes> hull, double target)
{
    dimension_ = 3;
    Vec3 sum;
    for (const FacetNodes& face : hull) {
        for (const NodeId n : face) sum = sum + complex_.position(n);
    }
    best_ = {{}, (1.0 / (3.0 * static_cast<double>(hull.size()))) * sum, {}, {}};
    star_.clear();
    score_ = std::numeric_limits<double>::infinity();
    double square = score_;
    for (const FacetNodes& face : hull) {
        const TetCorners p = {complex_.position(face[0]), complex_.position(face[1]),
                              complex_.position(face[2]), best_.position};
        star_.push_back({p, 3, dihedralScore(p)});
        score_ = std::min(score_, star_.back().score);
        for (std::size_t k = 0; k < 3; ++k) square = std::min(square, squaredLength(p[k] - best_.position));
    }
    shortest_ = std::sqrt(square);
    if (!(score_ > 0.0)) return false;
    climbTo(target);
    return isPositive();
}

}  // namespace mesher
