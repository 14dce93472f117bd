#pragma once

#include "base/bucket_queue.h"
#include "refinement/refinement_state3d.h"

#include <array>
#include <optional>
#include <vector>

namespace mesher {

/// The tetrahedra that are to be refined, the worst first, in one queue for each need. Entries go stale by themselves.
/// Reference    [gosselin] section 4.7.2
class BadTetQueue
{
public:
    using Entry = BucketQueue<TetId>::Entry;

    explicit BadTetQueue(RefinementState3d& state) : state_(state) {}

    /// Between these two calls only sinks are queued, whatever they need.
    void beginSinks() { isSinkPhase_ = true; }
    void endSinks();
    [[nodiscard]] bool isSinkPhase() const { return isSinkPhase_; }

    /// Queues a meshed tetrahedron if it needs anything.
    void push(TetId tet);
    /// All that are meshed.
    void pushAll();
    /// Puts an entry back that was taken and could not be served yet.
    void pushAgain(const Entry& entry, TetNeed need)
    {
        queueFor(need).push(entry.id, entry.generation, entry.key);
    }
    [[nodiscard]] bool hasHeldBack() const { return !heldBack_.empty(); }
    /// Queues those that lambda has held back, as far as they are there still and it does not any more. How many.
    std::size_t pushHeldBack();
    /// A vertex has become low: lowers the length scales around it and queues what is too large by them.
    void gradeAround(VertexId v);

    [[nodiscard]] std::optional<Entry> takeSink();
    [[nodiscard]] std::optional<Entry> take(TetNeed need);
    /// Stale entries included.
    [[nodiscard]] std::size_t size() const { return sinks_.size() + sizes_.size() + qualities_.size(); }

private:
    [[nodiscard]] bool isCurrent(const Entry& entry) const;
    BucketQueue<TetId>& queueFor(TetNeed need) { return need == TetNeed::Size ? sizes_ : qualities_; }
    void pushStar(VertexId v);

    RefinementState3d& state_;
    BucketQueue<TetId> sinks_;
    BucketQueue<TetId> sizes_;
    BucketQueue<TetId> qualities_;
    std::vector<Entry> heldBack_;
    std::vector<VertexId> lowered_;
    std::vector<TetId> star_;
    bool isSinkPhase_ = false;
};

}  // namespace mesher
