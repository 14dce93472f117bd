#include "refinement/work_ledger3d.h"

#include <algorithm>

namespace mesher {

WorkLedger3d::WorkLedger3d(const ConstrainedTetrahedralization& tetrahedralization,
                           const WorkAllowance& allowance)
    : t_(tetrahedralization),
      free_(allowance.free + allowance.perTet * static_cast<double>(t_.mesh().tetCount())),
      perVertex_(allowance.perVertex),
      first_(work()),
      last_(first_),
      verticesAtStart_(t_.mesh().vertexCount())
{
}

void WorkLedger3d::charge(EntityRef entity)
{
    const std::uint64_t spent = work() - last_;
    settle();
    const std::uint64_t key = std::uint64_t{entity.dimension} << 32 | entity.index;
    entries_.insert(key, Entry{entity}).first->work += spent;
}

bool WorkLedger3d::isSpent() const
{
    const double spent = static_cast<double>(work() - first_);
    if (spent <= free_) return false;
    // Vertices that came and went again are no headway.
    const double made = static_cast<double>(t_.mesh().vertexCount()) - static_cast<double>(verticesAtStart_);
    return spent > free_ + perVertex_ * std::max(made, 0.0);
}

std::vector<WorkLedger3d::Entry> WorkLedger3d::costliest(std::size_t most) const
{
    std::vector<Entry> sorted;
    double all = 0.0;
    for (const auto& [key, entry] : entries_) {
        sorted.push_back(entry);
        all += static_cast<double>(entry.work);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Entry& a, const Entry& b) { return a.work > b.work; });
    if (sorted.size() > most) sorted.resize(most);
    for (Entry& entry : sorted) entry.share = static_cast<double>(entry.work) / std::max(all, 1.0);
    return sorted;
}

}  // namespace mesher
