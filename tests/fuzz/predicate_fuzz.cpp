// Compares the predicates and their perturbed versions with exact integer arithmetic on point sets that are
// degenerate or nearly so. Case number i of a kind and a seed is always the same points.

#include "base/box.h"
#include "predicates/coordinate_range.h"
#include "predicates/incircle.h"
#include "predicates/insphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/predicate_tiers.h"
#include "support/exact_oracle.h"
#include "support/predicate_points.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace mesher;
using namespace mesher::test;

constexpr std::array<const char*, 4> kPredicateNames{"orient2d", "incircle", "orient3d", "insphere"};
constexpr std::uint64_t kMostReports = 20;

struct Options
{
    std::uint64_t cases = 200000;
    std::uint64_t seed = 1;
    std::uint64_t from = 0;
    std::vector<PointKind> kinds{PointKind::Random,   PointKind::Grid, PointKind::Cospherical,
                                 PointKind::Coplanar, PointKind::Ulp,  PointKind::Range};
};

class Campaign
{
public:
    Campaign(PointKind kind, const Options& options) : kind_(kind), options_(options) {}

    std::uint64_t run()
    {
        for (std::uint64_t i = options_.from; i < options_.from + options_.cases; ++i) {
            index_ = i;
            sets_ = makePointSets(kind_, options_.seed, i);
            checkPlane();
            checkSpace();
            if ((i + 1) % 1000000 == 0) {
                std::fprintf(stderr, "%s: %llu cases, %llu mismatches\n", kindName(),
                             static_cast<unsigned long long>(i + 1),
                             static_cast<unsigned long long>(mismatches_));
            }
        }
        print();
        return mismatches_;
    }

private:
    void checkPlane()
    {
        const std::vector<Vec2>& p = sets_.plane;
        for (const Vec2& point : p) expect(isInExactRange(point), "exact range");
        const StaticFilter2d filter = StaticFilter2d::forBox(Box2::of(p));
        const ExactOracle2d oracle(p);
        const Sign orientation = oracle.orientation();
        count(0, orientation, decideOrient2d(filter, p[0], p[1], p[2]), "orient2d tiers");
        expect(orient2d(p[0], p[1], p[2]) == orientation, "orient2d");
        expect(orient2d(filter, p[0], p[1], p[2]) == orientation, "orient2d, filtered");
        const Sign circle = oracle.sphere();
        count(1, circle, decideIncircle(filter, p[0], p[1], p[2], p[3]), "incircle tiers");
        expect(incircle(p[0], p[1], p[2], p[3]) == circle, "incircle");
        expect(incircle(filter, p[0], p[1], p[2], p[3]) == circle, "incircle, filtered");
        const Sign perturbed = isPerturbationDue(circle) ? oracle.perturbedSphere() : circle;
        expect(incirclePerturbed(p[0], p[1], p[2], p[3]) == perturbed, "incirclePerturbed");
        expect(incirclePerturbed(filter, p[0], p[1], p[2], p[3]) == perturbed, "incirclePerturbed, filtered");
    }

    void checkSpace()
    {
        const std::vector<Vec3>& p = sets_.space;
        for (const Vec3& point : p) expect(isInExactRange(point), "exact range");
        const StaticFilter3d filter = StaticFilter3d::forBox(Box3::of(p));
        const ExactOracle3d oracle(p);
        const Sign orientation = oracle.orientation();
        count(2, orientation, decideOrient3d(filter, p[0], p[1], p[2], p[3]), "orient3d tiers");
        expect(orient3d(p[0], p[1], p[2], p[3]) == orientation, "orient3d");
        expect(orient3d(filter, p[0], p[1], p[2], p[3]) == orientation, "orient3d, filtered");
        const Sign sphere = oracle.sphere();
        count(3, sphere, decideInsphere(filter, p[0], p[1], p[2], p[3], p[4]), "insphere tiers");
        expect(insphere(p[0], p[1], p[2], p[3], p[4]) == sphere, "insphere");
        expect(insphere(filter, p[0], p[1], p[2], p[3], p[4]) == sphere, "insphere, filtered");
        const Sign perturbed = isPerturbationDue(sphere) ? oracle.perturbedSphere() : sphere;
        expect(inspherePerturbed(p[0], p[1], p[2], p[3], p[4]) == perturbed, "inspherePerturbed");
        expect(inspherePerturbed(filter, p[0], p[1], p[2], p[3], p[4]) == perturbed,
               "inspherePerturbed, filtered");
    }

    /// The perturbation may matter only for a zero; a hundredth of the other cases checks that it does not.
    [[nodiscard]] bool isPerturbationDue(Sign sign) const { return sign == Sign::Zero || index_ % 100 == 0; }

    void count(std::size_t predicate, Sign expected, const Decision& decision, const char* what)
    {
        ++histogram_[predicate][static_cast<std::size_t>(decision.tier)];
        zeros_[predicate] += expected == Sign::Zero ? 1 : 0;
        expect(decision.sign == expected, what);
    }

    void expect(bool holds, const char* what)
    {
        if (holds) return;
        ++mismatches_;
        if (mismatches_ > kMostReports) return;
        std::fprintf(stderr, "MISMATCH %s: --kind %s --seed %llu --from %llu --cases 1\n", what, kindName(),
                     static_cast<unsigned long long>(options_.seed), static_cast<unsigned long long>(index_));
        for (const Vec2& p : sets_.plane) std::fprintf(stderr, "  2D %a %a\n", p.x, p.y);
        for (const Vec3& p : sets_.space) std::fprintf(stderr, "  3D %a %a %a\n", p.x, p.y, p.z);
    }

    void print() const
    {
        std::printf(
            "{\"kind\": \"%s\", \"seed\": %llu, \"from\": %llu, \"cases\": %llu, \"mismatches\": %llu",
            kindName(), static_cast<unsigned long long>(options_.seed),
            static_cast<unsigned long long>(options_.from), static_cast<unsigned long long>(options_.cases),
            static_cast<unsigned long long>(mismatches_));
        for (std::size_t predicate = 0; predicate < kPredicateNames.size(); ++predicate) {
            std::printf(", \"%s\": {\"zero\": %llu", kPredicateNames[predicate],
                        static_cast<unsigned long long>(zeros_[predicate]));
            for (std::size_t tier = 0; tier < kTierCount; ++tier) {
                std::printf(", \"%s\": %llu", nameOf(static_cast<Tier>(tier)),
                            static_cast<unsigned long long>(histogram_[predicate][tier]));
            }
            std::printf("}");
        }
        std::printf("}\n");
        std::fflush(stdout);
    }

    [[nodiscard]] const char* kindName() const
    {
        return kPointKindNames[static_cast<std::size_t>(kind_)].data();
    }

    PointKind kind_;
    const Options& options_;
    std::uint64_t index_ = 0;
    std::uint64_t mismatches_ = 0;
    PointSets sets_;
    std::array<std::array<std::uint64_t, kTierCount>, 4> histogram_{};
    std::array<std::uint64_t, 4> zeros_{};
};

[[noreturn]] void refuse(const std::string& why)
{
    std::fprintf(stderr,
                 "%s\nusage: predicate_fuzz [--cases N] [--seed S] [--from I] [--kind K]\n"
                 "  K: random grid cospherical coplanar ulp range (default: all, N cases each)\n",
                 why.c_str());
    std::exit(2);
}

std::uint64_t numberOf(std::string_view text)
{
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        refuse("not a number: " + std::string(text));
    return number;
}

Options readOptions(const std::vector<std::string_view>& arguments)
{
    Options options;
    for (std::size_t i = 0; i < arguments.size(); i += 2) {
        const std::string_view name = arguments[i];
        if (i + 1 == arguments.size()) refuse("no value for " + std::string(name));
        const std::string_view value = arguments[i + 1];
        if (name == "--cases")
            options.cases = numberOf(value);
        else if (name == "--seed")
            options.seed = numberOf(value);
        else if (name == "--from")
            options.from = numberOf(value);
        else if (name == "--kind") {
            const auto kind = pointKindOf(value);
            if (!kind) refuse("unknown kind " + std::string(value));
            options.kinds = {*kind};
        } else
            refuse("unknown option " + std::string(name));
    }
    return options;
}

}  // namespace

int main(int argc, char** argv)
{
    const Options options = readOptions({argv + 1, argv + argc});
    std::uint64_t mismatches = 0;
    for (const PointKind kind : options.kinds) mismatches += Campaign(kind, options).run();
    return mismatches == 0 ? 0 : 1;
}
