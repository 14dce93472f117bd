#include "pipeline/component_contacts.h"

#include "pipeline/common_volume.h"
#include "pipeline/component_surface.h"
#include "pipeline/overlap_depth.h"
#include "pipeline/report_steps.h"
#include "pipeline/solid_contacts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

namespace mesher {

namespace {

/// Of the smaller group's extent: what CAD programs leave between parts that are meant to touch.
constexpr double kContactShare = 1e-6;

double largestTolerance(const BrepModel& model)
{
    double largest = 0.0;
    for (const BrepFace& face : model.faces) largest = std::max(largest, face.tolerance);
    return largest;
}

double toleranceBetween(const ComponentSurface& a, const ComponentSurface& b)
{
    const double size = std::min(length(a.box().extent()), length(b.box().extent()));
    return std::max(kContactShare * size, largestTolerance(a.model()) + largestTolerance(b.model()));
}

SolidOverlap pairOf(const SampledComponent& a, const SampledComponent& b, const SolidContact& contact)
{
    const EntityRef first = a.component->inWhole(EntityRef{3, contact.first.value});
    const EntityRef second = b.component->inWhole(EntityRef{3, contact.second.value});
    return {std::min(first, second), std::max(first, second), contact.place};
}

std::string namesOf(const SolidOverlap& pair) { return nameOf(pair.first) + " and " + nameOf(pair.second); }

void warn(const Error& error, MeshReport& report)
{
    std::string clause = describe(error);
    clause.pop_back();
    report.warnings.push_back(std::move(clause));
}

void tellTouch(const SolidOverlap& pair, MeshReport& report)
{
    warn({ErrorCode::InvalidArgument,
          "the solids touch without a common face, so their meshes do not fit together there", namesOf(pair),
          pair.place, "make them share it, by boolean fragments for one"},
         report);
}

constexpr const char* kApart = "cut one from the other or fuse them in the CAD program";

void refuse(const SolidOverlap& pair, MeshReport& report)
{
    fail(report, {ErrorCode::IntersectingConstraints, "the solids overlap", namesOf(pair), pair.place,
                  std::string(kApart) + ", or leave --overlap as it is, which gives each a mesh of its own"});
}

std::string threeDigitsOf(double value)
{
    std::array<char, 32> text{};
    const auto [end, code] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
    return std::string(text.data(), static_cast<std::size_t>(end - text.data()));
}

/// The surface of each group, made where another group is near.
class Surfaces
{
public:
    explicit Surfaces(std::span<const SampledComponent> components)
        : components_(components), surfaces_(components.size())
    {
        for (const SampledComponent& c : components) {
            Box3 box;
            for (const MeshNode& node : c.mesh->nodes) box.include(node.position);
            boxes_.push_back(box);
        }
    }

    [[nodiscard]] bool areNear(std::size_t i, std::size_t j) const
    {
        // Facets may be inside of their faces by a part of the smaller group.
        const double size = std::min(length(boxes_[i].extent()), length(boxes_[j].extent()));
        const Vec3 margin{0.25 * size, 0.25 * size, 0.25 * size};
        const Box3 box{boxes_[i].low - margin, boxes_[i].high + margin};
        const Box3& that = boxes_[j];
        return box.low.x <= that.high.x && that.low.x <= box.high.x && box.low.y <= that.high.y &&
               that.low.y <= box.high.y && box.low.z <= that.high.z && that.low.z <= box.high.z;
    }

    [[nodiscard]] const ComponentSurface& at(std::size_t i)
    {
        const SampledComponent& c = components_[i];
        if (!surfaces_[i]) surfaces_[i].emplace(c.component->model, *c.mesh, *c.sides);
        return *surfaces_[i];
    }

private:
    std::span<const SampledComponent> components_;
    std::vector<Box3> boxes_;
    std::vector<std::optional<ComponentSurface>> surfaces_;
};

}  // namespace

std::vector<SolidOverlap> tellContacts(std::span<const SampledComponent> components, MeshReport& report,
                                       RunContext& context)
{
    Surfaces surfaces(components);
    std::vector<SolidOverlap> overlaps;
    for (std::size_t i = 0; i < components.size(); ++i) {
        for (std::size_t j = i + 1; j < components.size(); ++j) {
            if (!surfaces.areNear(i, j)) continue;
            if (!context.mayGoOn()) return overlaps;
            const ComponentSurface& a = surfaces.at(i);
            const ComponentSurface& b = surfaces.at(j);
            const std::optional<SolidContact> contact = findContact(a, b, toleranceBetween(a, b), context);
            if (!contact) continue;
            SolidOverlap pair = pairOf(components[i], components[j], *contact);
            if (!contact->isOverlap) {
                tellTouch(pair, report);
                continue;
            }
            if (report.options.overlap == OverlapChoice::Refuse) {
                refuse(pair, report);
            } else {
                pair.commonVolume = shallowCommonVolume(a, b, toleranceBetween(a, b));
            }
            overlaps.push_back(pair);
        }
    }
    return overlaps;
}

void tellOverlaps(std::span<const SolidOverlap> overlaps, const ClassifiedMesh& mesh, const std::string& unit,
                  MeshReport& report)
{
    if (overlaps.empty()) return;
    const CommonVolumes volumes(mesh);
    for (const SolidOverlap& pair : overlaps) {
        const double volume =
            pair.commonVolume ? *pair.commonVolume : volumes.between(pair.first.index, pair.second.index);
        const std::string share =
            volume > 0.0 ? "they have about " + threeDigitsOf(volume) + " " + unit + "^3 in common"
                         : "they have less in common than their meshes can tell";
        warn({ErrorCode::IntersectingConstraints,
              "the solids overlap, and each has a mesh of its own there; " + share, namesOf(pair), pair.place,
              kApart},
             report);
    }
}

}  // namespace mesher
