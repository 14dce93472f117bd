#include "delaunay/constrained_flips3d.h"

#include "delaunay/flips3d.h"
#include "delaunay/hole_refill.h"
#include "delaunay/tet_replacement3d.h"
#include "predicates/insphere.h"
#include "predicates/orient3d.h"

#include <algorithm>
#include <deque>
#include <optional>

namespace mesher {

namespace {

/// Tetrahedra that are filled anew at once.
constexpr std::size_t kMaxCavity = 200;
/// Looked at between two questions to the budget.
constexpr std::uint32_t kTetsPerCheck = 1u << 16;

}  // namespace

class ConstrainedFlips3d::Work
{
public:
    Work(Delaunay3d& delaunay, DelaunayPart part);

    void pushAll(Budget& budget);
    void push(std::span<const TetId> tets);
    void flip(Budget& budget);
    void flipAndFill(Budget& budget);
    [[nodiscard]] bool isNotDelaunay(TetFace face) const;

    std::vector<TetId> created;
    std::vector<TetFace> left;  ///< that were stuck in the end
    ConstrainedFlipCounts counts;

private:
    struct Entry
    {
        TetFace face;
        std::uint16_t generation;
    };

    [[nodiscard]] bool isOfPart(TetId tet) const;
    [[nodiscard]] bool isCurrent(const Entry& entry) const;
    void pushIfNotDelaunay(TetFace face);
    void pushCreated(const std::vector<TetId>& tets);
    void forgetWaiting();
    void flipQueue(Budget& budget);
    void flipUntilStuck(Budget& budget);
    [[nodiscard]] std::optional<Flip3d> findFlip(TetFace face) const;
    [[nodiscard]] std::optional<Flip3d> findFlip44(TetId tet, int edge, VertexId above, VertexId below) const;

    bool fillStuckOnes(Budget& budget);

    Triangulation3d& mesh_;
    const StaticFilter3d& filter_;
    DelaunayPart part_;
    TetReplacement3d replacement_;
    HoleRefill holes_;
    std::deque<Entry> queue_;
    std::vector<Entry> stuck_;
};

ConstrainedFlips3d::Work::Work(Delaunay3d& delaunay, DelaunayPart part)
    : mesh_(delaunay.triangulation()),
      filter_(delaunay.filter()),
      part_(part),
      replacement_(mesh_),
      holes_(mesh_)
{
}

bool ConstrainedFlips3d::Work::isOfPart(TetId tet) const
{
    return mesh_.isAlive(tet) && !mesh_.isGhostTet(tet) &&
           (part_ == DelaunayPart::Everywhere || mesh_.region(tet) != kExteriorRegion);
}

void ConstrainedFlips3d::Work::pushAll(Budget& budget)
{
    for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
        const TetId tet(i);
        if (i % kTetsPerCheck == 0 && !budget.allows({mesh_.vertexCount(), mesh_.tetCount()})) return;
        if (!isOfPart(tet)) continue;
        for (int face = 0; face < 4; ++face) {
            if (tet < mesh_.neighbour(tet, face).tet()) pushIfNotDelaunay({tet, face});
        }
    }
}

void ConstrainedFlips3d::Work::push(std::span<const TetId> tets)
{
    for (const TetId tet : tets) {
        if (!isOfPart(tet)) continue;
        for (int face = 0; face < 4; ++face) pushIfNotDelaunay({tet, face});
    }
}

void ConstrainedFlips3d::Work::forgetWaiting()
{
    left.clear();
    for (const Entry& entry : stuck_) left.push_back(entry.face);
    queue_.clear();
    stuck_.clear();
}

void ConstrainedFlips3d::Work::flip(Budget& budget)
{
    flipUntilStuck(budget);
    forgetWaiting();
}

void ConstrainedFlips3d::Work::flipAndFill(Budget& budget)
{
    do {
        flipUntilStuck(budget);
    } while (fillStuckOnes(budget));
    forgetWaiting();
}

bool ConstrainedFlips3d::Work::isCurrent(const Entry& entry) const
{
    return mesh_.isAlive(entry.face.tet()) && mesh_.generation(entry.face.tet()) == entry.generation;
}

bool ConstrainedFlips3d::Work::isNotDelaunay(TetFace face) const
{
    const TetFace other = mesh_.neighbour(face);
    if (mesh_.isGhostTet(face.tet()) || mesh_.isGhostTet(other.tet()) || mesh_.isFaceConstrained(face))
        return false;
    const auto& v = mesh_.tet(face.tet()).vertex;
    return insphere(filter_, mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]),
                    mesh_.position(v[3]),
                    mesh_.position(mesh_.vertex(other.tet(), other.face()))) == Sign::Positive;
}

void ConstrainedFlips3d::Work::pushIfNotDelaunay(TetFace face)
{
    if (isNotDelaunay(face)) queue_.push_back({face, mesh_.generation(face.tet())});
}

void ConstrainedFlips3d::Work::pushCreated(const std::vector<TetId>& tets)
{
    push(tets);
    created.insert(created.end(), tets.begin(), tets.end());
}

void ConstrainedFlips3d::Work::flipQueue(Budget& budget)
{
    while (!queue_.empty()) {
        const Entry entry = queue_.front();
        queue_.pop_front();
        if (!isCurrent(entry) || !isNotDelaunay(entry.face)) continue;
        if (!budget.allows({mesh_.vertexCount(), mesh_.tetCount()})) return;
        const std::optional<Flip3d> flip = findFlip(entry.face);
        if (!flip) {
            stuck_.push_back(entry);
            continue;
        }
        applyFlip(replacement_, *flip);
        ++counts.flips;
        pushCreated(replacement_.created());
    }
}

/// A face may wait for a flip beside it.
void ConstrainedFlips3d::Work::flipUntilStuck(Budget& budget)
{
    std::uint64_t before = 0;
    do {
        before = counts.flips;
        queue_.insert(queue_.end(), stuck_.begin(), stuck_.end());
        stuck_.clear();
        flipQueue(budget);
    } while (counts.flips > before && !stuck_.empty() && !budget.exhausted());
}

/// The flip of the convex union of the tetrahedra at the face: 2-3 inside of it, 3-2 or 4-4 at an edge of it.
std::optional<Flip3d> ConstrainedFlips3d::Work::findFlip(TetFace face) const
{
    if (auto flip = evaluateFlip23(mesh_, face)) return flip;
    const TetFace other = mesh_.neighbour(face);
    const VertexId above = mesh_.vertex(face.tet(), face.face());
    const VertexId below = mesh_.vertex(other.tet(), other.face());
    const auto corner = mesh_.faceVertices(face);
    for (unsigned k = 0; k < 3; ++k) {
        const VertexId a = corner[k];
        const VertexId b = corner[(k + 1) % 3];
        const int edge = kEdgeOfSlots[mesh_.slotOf(face.tet(), a)][mesh_.slotOf(face.tet(), b)];
        const Sign bend = orient3d(filter_, mesh_.position(a), mesh_.position(b), mesh_.position(below),
                                   mesh_.position(above));
        if (bend == Sign::Zero) {
            if (auto flip = findFlip44(face.tet(), edge, above, below)) return flip;
        } else if (auto flip = evaluateFlip32(mesh_, face.tet(), edge)) {
            return flip;
        }
    }
    return {};
}

/// The 4-4 flip that joins the two apices, which lie in one plane with the edge.
std::optional<Flip3d> ConstrainedFlips3d::Work::findFlip44(TetId tet, int edge, VertexId above,
                                                           VertexId below) const
{
    for (const int diagonal : {0, 1}) {
        auto flip = evaluateFlip44(mesh_, tet, edge, diagonal);
        if (!flip || !flip->constrainedFaces.empty()) continue;
        const TetCorners& corners = flip->after.front();
        const auto has = [&](VertexId v) {
            return std::find(corners.begin(), corners.end(), v) != corners.end();
        };
        if (has(above) && has(below)) return flip;
    }
    return {};
}

/// Fills the tetrahedra at stuck faces with Delaunay ones. Whether any was changed.
bool ConstrainedFlips3d::Work::fillStuckOnes(Budget& budget)
{
    std::vector<Entry> stuck;
    stuck.swap(stuck_);
    bool isChanged = false;
    for (const Entry& entry : stuck) {
        if (!isCurrent(entry) || !isNotDelaunay(entry.face)) continue;
        if (!budget.allows({mesh_.vertexCount(), mesh_.tetCount()})) return false;
        const TetId tets[] = {entry.face.tet(), mesh_.neighbour(entry.face).tet()};
        if (!holes_.refill(tets, VertexId(), kMaxCavity)) {
            stuck_.push_back(entry);
            continue;
        }
        isChanged = true;
        ++counts.cavities;
        pushCreated(holes_.created());
    }
    return isChanged;
}

ConstrainedFlips3d::ConstrainedFlips3d(Delaunay3d& delaunay, DelaunayPart part)
    : work_(std::make_unique<Work>(delaunay, part))
{
}

ConstrainedFlips3d::~ConstrainedFlips3d() = default;

void ConstrainedFlips3d::pushAll(Budget& budget) { work_->pushAll(budget); }
void ConstrainedFlips3d::push(std::span<const TetId> tets) { work_->push(tets); }
void ConstrainedFlips3d::flip(Budget& budget) { work_->flip(budget); }
void ConstrainedFlips3d::flipAndFill(Budget& budget) { work_->flipAndFill(budget); }
const std::vector<TetId>& ConstrainedFlips3d::created() const { return work_->created; }
void ConstrainedFlips3d::clearCreated() { work_->created.clear(); }
const std::vector<TetFace>& ConstrainedFlips3d::stuck() const { return work_->left; }
bool ConstrainedFlips3d::isNotDelaunay(TetFace face) const { return work_->isNotDelaunay(face); }
const ConstrainedFlipCounts& ConstrainedFlips3d::counts() const { return work_->counts; }

}  // namespace mesher
