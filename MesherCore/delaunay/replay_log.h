#pragma once

#include "base/result.h"
#include "base/vec.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace mesher {

enum class ReplayKind : std::uint8_t
{
    Insert,           ///< a point, and the label it is known by from now on
    Remove,           ///< a labelled vertex
    RemoveFromChain,  ///< a labelled vertex, joining collinear constrained edges
    Constrain,        ///< the segment or triangle between labelled vertices
    Unconstrain       ///< the same, given free
};

/// One change of a triangulation. Vertices are named by labels, not by what an insertion returns, so that a log stays
/// meaningful when operations are taken out of it; a label is any number, and is bound anew by a later Insert.
struct ReplayOperation
{
    ReplayKind kind = ReplayKind::Insert;
    std::uint8_t labelCount = 0;
    std::uint8_t coordinateCount = 0;
    std::array<std::uint32_t, 3> labels{};
    std::array<double, 3> coordinates{};

    friend bool operator==(const ReplayOperation&, const ReplayOperation&) = default;

    static ReplayOperation insert(std::uint32_t label, Vec2 point);
    static ReplayOperation insert(std::uint32_t label, Vec3 point);
    static ReplayOperation on(ReplayKind kind, std::initializer_list<std::uint32_t> labels);
};

/// What was done to a triangulation, in order: enough to do it again, bit for bit. Of two or three dimensions.
class ReplayLog
{
public:
    ReplayLog() = default;
    explicit ReplayLog(std::vector<ReplayOperation> operations) : operations_(std::move(operations)) {}

    void add(const ReplayOperation& operation) { operations_.push_back(operation); }
    void clear() { operations_.clear(); }
    [[nodiscard]] const std::vector<ReplayOperation>& operations() const { return operations_; }

    /// One operation a line: its name, labels, then coordinates as hexadecimal floats, which lose nothing.
    [[nodiscard]] std::string toText() const;
    /// Refuses what toText does not write, with the number of the line.
    [[nodiscard]] static Result<ReplayLog> fromText(std::string_view text);

private:
    std::vector<ReplayOperation> operations_;
};

}  // namespace mesher
